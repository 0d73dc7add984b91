"""The paper's figures and campaigns."""
