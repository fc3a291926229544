"""The same sheets through MuJoCo's batch and through ours, in one run."""
