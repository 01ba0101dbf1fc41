"""`minipov diff`: how close one picture is to another, and minipov's to POV-Ray's.

`reference` runs POV-Ray and remembers its pictures, `ours` runs minipov, `metrics` measures a pair, `verdict` names its
class, `survey` does many scenes, `page` and `table` show the outcome, `command` is the command line.
"""
