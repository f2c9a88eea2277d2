/* A process that does nothing, to compare with. */
int main(void) { return 0; }
