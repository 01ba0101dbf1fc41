"""What an editor asks about a text in SDL, without any protocol.

>>> from minipov.editor.analysis.document import Document
>>> from minipov.editor.analysis.syntax import syntax_problems
>>> [problem.message for problem in syntax_problems(Document("sphere { <0, 0, }"))]
["unexpected '}', expected '>'"]
"""
