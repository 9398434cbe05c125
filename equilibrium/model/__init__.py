"""Contacts and grasps, exact: what a question is made of."""
