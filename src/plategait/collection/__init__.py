"""Collections: estimates of many objects, one by one or on a cluster, killed at any moment and resumed."""
