"""What people say, as intents: sentences in three languages, one JSON schema."""
