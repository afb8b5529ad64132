package org.starl.lang.eval;

/**
 * A value of a sum.
 *
 * @param constructor its number from 0
 */
public record Form(int constructor, Row fields) {}
