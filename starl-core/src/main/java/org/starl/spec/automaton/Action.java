package org.starl.spec.automaton;

/** An action of an {@link Automaton}: in the theory, a value of the data type {@code actions}. */
public interface Action extends Term {}
