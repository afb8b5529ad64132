package org.starl.spec.automaton;

import java.util.List;

/**
 * A value of a theory's data type: a record that has the constructor's name, and the constructor's
 * arguments as components, in order.
 */
public interface Term {

  /** The arguments, in order: ids, names, numbers, sets of them, and terms. */
  List<Object> args();

  /** {@code od_mutex}. */
  default String name() {
    return getClass().getSimpleName();
  }

  /** {@code od_mutex(bot1, [A, C])}; without arguments, the name alone. */
  default String text() {
    StringBuilder text = new StringBuilder(name());
    String separator = "(";
    for (Object arg : args()) {
      text.append(separator).append(arg instanceof Term term ? term.text() : arg);
      separator = ", ";
    }
    return text.append(args().isEmpty() ? "" : ")").toString();
  }
}
