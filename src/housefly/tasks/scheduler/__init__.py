"""Which task flies when: a bounded queue, priorities, pre-emption, deadlines, kept in a file."""
