package org.starl.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.starl.input.BadInput;
import org.starl.input.Quantities;
import org.starl.random.Rng;

/**
 * The times at which a run begins to draw other random numbers: delays and losses of datagrams sent
 * later, the numbers of robots' programs, errors of fixes and wheels, the robots that later faults
 * choose. Until the first time the run is that of its seed.
 *
 * <p>What was drawn before stays: the floor and the starts, the plan of chaos with the times of its
 * faults, the datagrams that are on their way, the timers that are set. So does what a robot has once
 * drawn for its whole life, which is the phase of its fixes.
 *
 * @param all in the order of the text
 */
public record Redraws(List<One> all) {

  public static final Redraws NONE = new Redraws(List.of());

  /** Matches every text that {@link #parse} accepts, and some others. */
  static final String PATTERN = "^\\s*([^#;]+#\\s*\\d+\\s*(;[^#;]+#\\s*\\d+\\s*)*)?$";

  private static final String EXPECTED = ": expected a time and a whole number, such as 12.3s#17";

  /**
   * One time.
   *
   * @param atNs in ns of virtual time, at least 0
   * @param number at least 0; names the numbers that are drawn from then on
   */
  public record One(long atNs, long number) {

    private static One parse(String text) {
      int hash = text.indexOf('#');
      if (hash < 0) {
        throw new BadInput(BadInput.quote(text) + EXPECTED);
      }
      return new One(
          Quantities.durationNs(text.substring(0, hash)),
          Quantities.whole(text.substring(hash + 1), 0, Long.MAX_VALUE));
    }

    @Override
    public String toString() {
      return Quantities.durationText(atNs) + "#" + number;
    }
  }

  public Redraws {
    all = List.copyOf(all);
  }

  /** @throws BadInput if the text is not a list with {@code ;} of times and numbers */
  public static Redraws parse(String text) {
    List<One> all = new ArrayList<>();
    for (String part : text.split(";", -1)) {
      if (!part.isBlank()) {
        all.add(One.parse(part));
      }
    }
    return new Redraws(all);
  }

  /** These, then one more. */
  public Redraws plus(One more) {
    List<One> longer = new ArrayList<>(all);
    longer.add(more);
    return new Redraws(longer);
  }

  /** Plans the redraws of a run that begins. */
  void install(Engine engine, Rng.Redraw redraw) {
    all.forEach(one -> engine.at(one.atNs, () -> redraw.with(one.number)));
  }

  @Override
  public String toString() {
    return all.stream().map(One::toString).collect(Collectors.joining(";"));
  }
}
