package org.starl.lang.prove;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.starl.lang.tree.Automaton;
import org.starl.lang.tree.Type.Field;

/**
 * What the names of an expression stand for.
 *
 * @param state the name of the state before its components' names, with the path to a used automaton: {@code s.}
 * @param cells the components of that state
 * @param variables parameters and bound variables
 */
record Scope(
    Automaton automaton, String state, Map<String, Val> cells, Map<String, Val> variables) {

  Val cell(String name) {
    return Objects.requireNonNull(cells.get(name), name);
  }

  Val variable(String name) {
    return Objects.requireNonNull(variables.get(name), name);
  }

  Scope with(String name, Val value) {
    Map<String, Val> more = new LinkedHashMap<>(variables);
    more.put(name, value);
    return new Scope(automaton, state, cells, more);
  }

  /** These names alone. */
  Scope only(List<Field> names, List<Val> values) {
    Map<String, Val> all = new LinkedHashMap<>();
    for (int i = 0; i < names.size(); i++) {
      all.put(names.get(i).name(), values.get(i));
    }
    return new Scope(automaton, state, cells, all);
  }

  /** The used automaton in a component. */
  Scope used(String component) {
    Automaton used = Objects.requireNonNull(automaton.uses().get(component), component);
    return new Scope(
        used, state + component + ".", ((Val.Cells) cell(component)).cells(), variables);
  }
}
