"""Memory of the STM32G431CB (RM0440 2.2): ranges of addresses."""

FLASH = range(0x08000000, 0x08020000)
CODE = range(0x08000000, 0x08000000 + 43 * 2048)  # the pages before the node's own
SRAM = range(0x20000000, 0x20005800)
CCM = range(0x10000000, 0x10002800)
