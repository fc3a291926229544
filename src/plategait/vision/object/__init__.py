"""How the object lies, seen by markers or by texture."""
