package org.starl.lang.tree;

import java.util.List;
import org.starl.lang.tree.Type.Field;

/**
 * What a call of a function needs to know of it.
 *
 * @param owner the automaton that declares it
 * @param readsState whether its value depends on the state
 */
public record Signature(
    String owner, String name, List<Field> parameters, Type result, boolean readsState) {}
