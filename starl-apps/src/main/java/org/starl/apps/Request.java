package org.starl.apps;

import java.util.OptionalInt;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import org.starl.body.MotionParameters;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.random.Rng;

/**
 * A user's request to run an app.
 *
 * @param robots their number, if the user gave it
 * @param parameters all parameters of the app: the user's values, else the defaults
 * @param given the keys of the parameters that the user gave, even if with the default value
 * @param motion the robots' motion, which decides how much room maps leave them; a demo takes that of
 *     its settings instead
 */
public record Request(
    long seed,
    OptionalInt robots,
    SortedMap<String, String> parameters,
    Set<String> given,
    MotionParameters motion) {

  /** A request in which all parameters are given. */
  public Request(long seed, OptionalInt robots, SortedMap<String, String> parameters) {
    this(seed, robots, parameters, parameters.keySet());
  }

  /** A request for robots that react at once, with exact wheels. */
  public Request(
      long seed, OptionalInt robots, SortedMap<String, String> parameters, Set<String> given) {
    this(seed, robots, parameters, given, MotionParameters.DEFAULT);
  }

  /** The value of a parameter that the app has declared. */
  public String parameter(String key) {
    String value = parameters.get(key);
    if (value == null) {
      throw new IllegalArgumentException("no parameter '" + key + "'");
    }
    return value;
  }

  /** This request with a number of robots drawn from the seed, unless the user gave one. */
  public Request drawRobots(int least, int most) {
    int drawn = least + new Rng(seed).fork("chaos/robots").nextInt(most - least + 1);
    return robots.isPresent()
        ? this
        : new Request(seed, OptionalInt.of(drawn), parameters, given, motion);
  }

  /** In half of the seeds this request, given another value, unless the user gave one. */
  public Request drawParameter(Parameter parameter, String other) {
    boolean isDrawn = new Rng(seed).fork("chaos/" + parameter.key()).nextBoolean(0.5);
    if (!isDrawn || given.contains(parameter.key())) {
      return this;
    }
    SortedMap<String, String> changed = new TreeMap<>(parameters);
    changed.put(parameter.key(), other);
    Set<String> more = new TreeSet<>(given);
    more.add(parameter.key());
    return new Request(seed, robots, changed, more, motion);
  }

  /**
   * Refuses a value of a parameter that only the simulator has.
   *
   * @throws BadInput unless it is the default
   */
  public void refuseOnRobots(Parameter parameter) {
    String value = parameter(parameter.key());
    if (!value.equals(parameter.defaultValue())) {
      throw new BadInput(
          parameter.key()
              + "="
              + BadInput.quote(value)
              + ": expected "
              + (parameter.defaultValue().isEmpty()
                  ? "none"
                  : BadInput.quote(parameter.defaultValue()))
              + " on robots without the simulator");
    }
  }

  /**
   * The value of a parameter whose form is a whole number.
   *
   * @throws BadInput if it is none; the message begins with the key
   */
  public int whole(Parameter parameter) {
    return StrictMath.toIntExact((Long) parameter.value(parameter(parameter.key())));
  }

  /**
   * The value of a parameter whose form is a quantity, in its unit: mm, mm/s, ns, rad, 1/s.
   *
   * @throws BadInput if it is none; the message begins with the key
   */
  public double amount(Parameter parameter) {
    return (Double) parameter.value(parameter(parameter.key()));
  }

  /**
   * The value of a parameter whose form is a choice.
   *
   * @throws BadInput if it is none; the message begins with the key
   */
  public String choice(Parameter parameter) {
    return (String) parameter.value(parameter(parameter.key()));
  }

  /**
   * Parses the value of a parameter that takes any text.
   *
   * @param parser throws {@link BadInput} if it cannot use the text
   * @throws BadInput of the parser, with the parameter's key before the message
   */
  public <T> T parse(Parameter parameter, Function<String, T> parser) {
    try {
      return parser.apply(parameter(parameter.key()));
    } catch (BadInput error) {
      throw Quantities.in(parameter.key(), error);
    }
  }
}
