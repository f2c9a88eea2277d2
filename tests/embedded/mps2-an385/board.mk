# A board as one's own would be: make embedded BOARD=tests/embedded/mps2-an385 (port/cortex-m/README.md).
CPU := -mcpu=cortex-m3 -mthumb -mfloat-abi=soft
SCRIPT := board.ld
EMULATED := mps2-an385
PARTS := c2d_link_free_zones c2d_set_body_force c2d_set_rigid
