package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.starl.input.Quantities;
import org.starl.random.Rng;

/**
 * The begin and end of a fault: {@code at=12s,for=5s}, {@code at=5s..20s,until=30s}. Without {@code
 * at} it begins with the run; without {@code for} and {@code until} it never ends.
 *
 * @param lasting null if the fault ends at {@code untilNs} or never
 * @param untilNs {@link #NEVER} if the fault ends otherwise or never
 */
public record Span(TimeRange at, @Nullable TimeRange lasting, long untilNs) {

  /** No end. */
  public static final long NEVER = Long.MAX_VALUE;

  public Span {
    if (lasting != null && untilNs != NEVER) {
      throw new IllegalArgumentException("expected an end by 'for' or by 'until', not by both");
    }
    if (untilNs < at.mostNs()) {
      throw new IllegalArgumentException("expected 'until' not to be before 'at'");
    }
  }

  /** A span between two times of the run, in ns. */
  public static Span between(long fromNs, long untilNs) {
    return new Span(TimeRange.exactly(fromNs), null, untilNs);
  }

  /** Whether the span has an end. */
  public boolean isFinite() {
    return lasting != null || untilNs != NEVER;
  }

  /** The earliest time at which it may begin. */
  public long earliestNs() {
    return at.leastNs();
  }

  /** The duration from a begin at {@code beginNs}, or {@link #NEVER}. */
  long drawLastingNs(long beginNs, Rng rng) {
    if (lasting != null) {
      return lasting.drawNs(rng);
    }
    return untilNs == NEVER ? NEVER : untilNs - beginNs;
  }

  /** Reads the times in {@code call}. */
  static Span read(FaultArguments call, String lastingKey) {
    TimeRange at = call.keyed("at", ArgumentType.TIME_RANGE, TimeRange.ZERO);
    String lasting = call.keyed(lastingKey);
    try {
      return new Span(
          at,
          lasting == null ? null : call.read(lastingKey, lasting, ArgumentType.TIME_RANGE),
          call.keyed("until", ArgumentType.DURATION, NEVER));
    } catch (IllegalArgumentException wrong) {
      throw call.bad(String.valueOf(wrong.getMessage()));
    }
  }

  /** As text: begin, then length. */
  List<String> arguments(String lastingKey) {
    List<String> arguments = new ArrayList<>();
    if (!at.equals(TimeRange.ZERO)) {
      arguments.add("at=" + at);
    }
    if (lasting != null) {
      arguments.add(lastingKey + "=" + lasting);
    }
    if (untilNs != NEVER) {
      arguments.add("until=" + Quantities.durationText(untilNs));
    }
    return arguments;
  }
}
