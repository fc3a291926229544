"""A strip that sags after its release."""
