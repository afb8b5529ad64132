package org.starl.lang.eval;

/** An element of an opaque type, by its number from 0. */
public record Id(int number) {}
