"""Colouring of SDL by words alone: a lexer for Pygments, and the TextMate grammar of the VS Code extension.

Both are made from the keyword table.
"""
