"""The language server, `minipov lsp`: requests of the Language Server Protocol, answered by `..analysis`."""
