package org.starl.spec.automaton;

import java.util.List;
import java.util.SortedSet;

/**
 * An operation of an automaton has no value for its arguments, or an effect is none. The message
 * begins with the place in the source: {@code Clock.starl:13:52: 1 - 2 is below 0}. The methods are
 * for classes that {@code starl compile} writes; each takes this place.
 */
public final class Undefined extends IllegalStateException {

  private static final long serialVersionUID = 1;

  private Undefined(String place, String told) {
    super(place + ": " + told);
  }

  /** {@code the(of)}. */
  public static <T> T the(String place, Lift<T> of) {
    if (!of.isUp()) {
      throw new Undefined(place, "the(none) has no value");
    }
    return of.get();
  }

  /** {@code head(of)}. */
  public static <T> T head(String place, List<T> of) {
    if (of.isEmpty()) {
      throw new Undefined(place, "head([]) has no value");
    }
    return of.get(0);
  }

  /** The least element of a set from which one is chosen. */
  public static <T> T choose(String place, SortedSet<T> of) {
    if (of.isEmpty()) {
      throw new Undefined(place, "nothing satisfies the condition of 'choose'");
    }
    return of.first();
  }

  /** {@code tail(of)}. */
  public static <T> List<T> tail(String place, List<T> of) {
    if (of.isEmpty()) {
      throw new Undefined(place, "tail([]) has no value");
    }
    return of.subList(1, of.size());
  }

  /** {@code of(n)}: the element that has {@code n} before it. */
  public static <T> T nth(String place, List<T> of, long n) {
    if (n < 0 || n >= of.size()) {
      throw new Undefined(place, "the list has " + of.size() + " elements, and none at " + n);
    }
    return of.get((int) n);
  }

  /** {@code of}, which must have the form that has this field. */
  public static <T> T form(String place, String field, Class<T> form, Object of) {
    if (!form.isInstance(of)) {
      String told =
          "'" + field + "' of " + of.getClass().getSimpleName() + ", which has no such field";
      throw new Undefined(place, told);
    }
    return form.cast(of);
  }

  /** {@code a - b} of naturals, or of times in whole units: at least 0. */
  public static long difference(String place, long a, long b) {
    if (a < b) {
      throw new Undefined(place, a + " - " + b + " is below 0");
    }
    return a - b;
  }

  /** {@code a - b} of times: at least 0. */
  public static double difference(String place, double a, double b) {
    if (a < b) {
      throw new Undefined(place, a + " - " + b + " is below 0");
    }
    return a - b;
  }

  /** {@code value}, which must be a number from {@code low} to {@code high}. */
  public static long within(String place, long low, long high, long value) {
    if (low > high) {
      throw new Undefined(place, "the range " + low + ".." + high + " is empty");
    }
    if (value < low || value > high) {
      throw new Undefined(place, value + " is not in " + low + ".." + high);
    }
    return value;
  }

  /** {@code a / b}; {@code b} is not 0. */
  public static double quotient(String place, double a, double b) {
    if (b == 0) {
      throw new Undefined(place, "a division by 0");
    }
    return a / b;
  }

  /** The remainder of {@code a} by {@code b}, from 0 to {@code b - 1}; {@code b} is above 0. */
  public static long remainder(String place, long a, long b) {
    if (b <= 0) {
      throw new Undefined(place, "a remainder by " + b + "; expected a number above 0");
    }
    return Math.floorMod(a, b);
  }

  /** The state of a used automaton after its step. */
  public static <S, A extends Action> S step(
      String place, String used, Automaton<S, A> automaton, A action, S state) {
    Enabled enabled = automaton.enabled(action, state);
    if (!enabled.isTrue()) {
      String step = used + "." + action.text();
      throw new Undefined(place, step + " is not enabled: " + enabled.falseConjunct());
    }
    return automaton.trans(action, state);
  }

  /** {@code after}, the state after an action that must not change one place to two values. */
  public static <S> S once(String place, boolean isTwice, String action, S after) {
    if (isTwice) {
      throw new Undefined(
          place, "'" + action + "' changes one place twice; expected one effect on it");
    }
    return after;
  }
}
