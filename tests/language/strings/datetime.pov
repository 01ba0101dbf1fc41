// datetime prints in a given format
#version 3.7;
#debug concat(datetime(0, "%Y-%m-%d"), "\n") // expect: 2000-01-01
#debug concat(datetime(1.5, "%H:%M"), "\n") // expect: 12:00
#debug concat(datetime(366, "%j %Y"), "\n") // expect: 001 2001
#debug concat(datetime(0), "\n") // expect: 2000-01-01 00:00:00Z
