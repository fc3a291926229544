"""`python -m plategait` is the command line."""

from plategait.cli import main

if __name__ == "__main__":
    main()
