package org.starl.spec.automaton;

import java.util.List;

/**
 * An action of an {@link Automaton}: a record whose name is the action's in its theory, and whose
 * components are the action's arguments, in order.
 */
public interface Action {

  /** The arguments, in order: ids, names, numbers, and sets of them. */
  List<Object> args();

  /** {@code od_mutex}. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** {@code od_mutex(bot1, [A, C])}. */
  default String text() {
    StringBuilder text = new StringBuilder(name()).append('(');
    String separator = "";
    for (Object arg : args()) {
      text.append(separator).append(arg);
      separator = ", ";
    }
    return text.append(')').toString();
  }
}
