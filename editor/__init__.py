"""SDL in an editor: an analysis library, a language server (`minipov lsp`), a VS Code extension, and a Pygments lexer.

`analysis` knows no protocol: a `Document` is a text, and each question about it is a function. `server` translates
questions and answers. What the language is, they read from the grammar, the keyword table and the constructs.
"""
