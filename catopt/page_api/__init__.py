"""What the page asks and is answered: dictionaries in, dictionaries out.

Nothing here knows of a browser or of a command line; `ask` answers the same in both.
"""

from catopt.page_api.calls import ABOUT_A_RUN, CALLS, ask, shell

__all__ = ["ABOUT_A_RUN", "CALLS", "ask", "shell"]
