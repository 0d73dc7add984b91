"""What ``import housefly`` offers beyond single classes: whole tasks as one function each.

``housefly/__init__.py`` lists the names, ``docs/python.md`` explains them.
"""
