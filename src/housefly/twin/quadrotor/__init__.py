"""The simulated quadrotor: body, motors, battery, sensors and the computer that flies it."""
