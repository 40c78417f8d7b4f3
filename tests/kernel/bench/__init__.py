"""What the kernel tests build their benches of: buses, lines, programs and an independent decoder."""
