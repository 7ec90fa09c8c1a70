"""What bench/charts and tools/chart are made of."""
