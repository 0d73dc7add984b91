"""The room for roslibjs, roslibpy and other clients of rosbridge."""
