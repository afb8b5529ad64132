package org.starl.spec.automaton;

/** An action of an {@link Automaton}, which in its theory is of the data type {@code actions}. */
public interface Action extends Term {}
