"""One typed tree from the site's TOML file."""
