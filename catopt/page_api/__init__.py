"""What the page asks and is answered: dictionaries in, dictionaries out.

Nothing here knows of a browser or of a command line; `ask` answers the same in both.
"""

from catopt.page_api.calls import CALLS, ask, shell

__all__ = ["CALLS", "ask", "shell"]
