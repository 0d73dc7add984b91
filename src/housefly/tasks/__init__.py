"""Services: what people, rules and other programs ask of the room becomes a task that is flown.

asked (a sentence, a button, a rule) -> intent -> task document -> rehearsal -> queue -> execution
"""
