package org.starl.sim.fault;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.starl.input.Quantities;
import org.starl.random.Rng;
import org.starl.time.Time;

/**
 * Draws fault plans. Each run of a campaign gets a random subset of the kinds of faults, each with
 * random strength: this finds more bugs than runs that all use every kind (Groce et al., "Swarm
 * testing", ISSTA 2012). All faults have ended by the given time.
 */
final class Chaos {

  private static final double MEAN_GAP_MS = 1500;
  private static final double MEAN_LASTING_MS = 2000;
  private static final long LEAST_LASTING_MS = 50;
  private static final long MOST_DROPOUT_MS = 1000;
  private static final String DROPOUT = "dropout(any)";

  private final Rng rng;
  private final long untilMs;
  private final List<Fault> faults = new ArrayList<>();

  private Chaos(Rng rng, long untilMs) {
    this.rng = rng;
    this.untilMs = untilMs;
  }

  static FaultPlan draw(Envelope envelope, int robots, long untilNs, Rng rng) {
    Chaos chaos = new Chaos(rng, untilNs / Time.NS_PER_MS);
    List<Supplier<String>> kinds = chaos.kinds(envelope);
    if (kinds.isEmpty() || chaos.untilMs <= LEAST_LASTING_MS) {
      return FaultPlan.NONE;
    }
    List<Supplier<String>> some = new ArrayList<>(kinds);
    some.removeIf(kind -> !rng.nextBoolean(0.6));
    chaos.addFaults(some.isEmpty() ? kinds : some);
    if (envelope == Envelope.MORTAL && rng.nextBoolean(0.7)) {
      chaos.addPermanentCrashes((robots - 1) / 2);
    }
    return new FaultPlan(chaos.faults);
  }

  private void addFaults(List<Supplier<String>> kinds) {
    // In some runs a fault lasts for the whole run, in most runs faults begin and end.
    if (rng.nextBoolean(0.3)) {
      add(network().get(rng.nextInt(network().size())).get(), 0, untilMs);
    }
    long atMs = Math.round(MEAN_GAP_MS / 2 * rng.nextExponential());
    while (atMs < untilMs - LEAST_LASTING_MS) {
      long lastingMs = LEAST_LASTING_MS + Math.round(MEAN_LASTING_MS * rng.nextExponential());
      String fault = kinds.get(rng.nextInt(kinds.size())).get();
      if (fault.equals(DROPOUT)) {
        lastingMs = Math.min(lastingMs, MOST_DROPOUT_MS);
      }
      add(fault, atMs, Math.min(untilMs, atMs + lastingMs));
      atMs += 1 + Math.round(MEAN_GAP_MS * rng.nextExponential());
    }
  }

  private void addPermanentCrashes(int most) {
    int crashes = most < 1 ? 0 : 1 + rng.nextInt(most);
    for (int i = 0; i < crashes; i++) {
      faults.add(FaultGrammar.parse("crash(any,at=" + rng.nextLong(0, untilMs) + "ms)"));
    }
  }

  /** Adds a fault, whose text has no times. */
  private void add(String text, long fromMs, long toMs) {
    FaultEffect effect = FaultGrammar.parse(text).effect();
    faults.add(new Fault(effect, Span.between(fromMs * Time.NS_PER_MS, toMs * Time.NS_PER_MS)));
  }

  /** Each kind draws a fault as text. */
  private List<Supplier<String>> kinds(Envelope envelope) {
    List<Supplier<String>> kinds = new ArrayList<>();
    if (envelope == Envelope.NONE) {
      return kinds;
    }
    kinds.addAll(network());
    if (envelope != Envelope.NETWORK && envelope != Envelope.SPATIAL) {
      // Crashes are drawn more often than other faults, because they matter most for these
      // envelopes.
      kinds.add(() -> fault("crash", "any", unsynced()));
      kinds.add(() -> fault("crash", anyOr("half"), unsynced()));
      kinds.add(() -> fault("disk", anyOr("all"), ms(1, 100)));
    }
    if (envelope == Envelope.HOSTILE) {
      kinds.add(() -> fault("forge", anyOr("all"), ms(10, 500)));
      kinds.add(() -> fault("replay", anyOr("all"), ms(10, 500)));
      kinds.add(() -> fault("flood", anyOr("all"), ms(5, 100)));
    }
    if (envelope == Envelope.LOGICAL
        || envelope == Envelope.MORTAL
        || envelope == Envelope.HOSTILE) {
      kinds.add(() -> fault("compute", anyOr("all"), ms(1, 20)));
      kinds.add(() -> fault("drift", "any", ppm(100_000)));
      kinds.add(() -> fault("skew", "any", ms(-1000, 1000)));
    }
    if (envelope == Envelope.SPATIAL || envelope == Envelope.MOVING) {
      kinds.add(() -> fault("drift", "any", ppm(200)));
    }
    if (envelope == Envelope.SPATIAL) {
      kinds.add(() -> fault("noise", anyOr("all"), rng.nextLong(1, 20) + "mm", angle()));
      kinds.add(() -> DROPOUT);
      kinds.add(() -> fault("slow", "any", percent(50, 100)));
      kinds.add(() -> "stuck(any)");
    }
    return kinds;
  }

  private List<Supplier<String>> network() {
    return List.of(
        () -> fault("loss", percent(5, 100), link()),
        () -> fault("burst", ms(200, 2000), ms(50, 1000), percent(50, 100), link()),
        () -> fault("delay", latency(), link()),
        () -> fault("duplicate", percent(5, 80), ms(1, 1000), link()),
        () -> fault("reorder", percent(5, 80), ms(1, 500), link()),
        () -> fault("partition", anyOr("half")),
        () -> fault("partition", anyOr("half") + ">" + (isDrawn(0.5) ? "all" : "half")));
  }

  /** The text of a fault; empty arguments are left out. */
  private static String fault(String name, String... arguments) {
    return Arrays.stream(arguments)
        .filter(argument -> !argument.isEmpty())
        .collect(Collectors.joining(",", name + "(", ")"));
  }

  private String latency() {
    return isDrawn(0.5) ? "uniform(0ms," + ms(1, 800) + ")" : "exponential(" + ms(1, 300) + ")";
  }

  private String link() {
    return isDrawn(0.6) ? "" : isDrawn(0.5) ? "from=any" : "to=any";
  }

  private String anyOr(String other) {
    return isDrawn(0.5) ? "any" : other;
  }

  private String unsynced() {
    return "lose=" + List.of("unsynced", "some", "nothing").get(rng.nextInt(3));
  }

  private String percent(int least, int most) {
    return Quantities.numberText(rng.nextLong(least, most) / 100.0);
  }

  private String ms(long least, long most) {
    return rng.nextLong(least, most) + "ms";
  }

  private String ppm(long most) {
    return rng.nextLong(-most, most) + "ppm";
  }

  private String angle() {
    return Quantities.angleText(rng.nextLong(0, 20) / 1000.0);
  }

  private boolean isDrawn(double probability) {
    return rng.nextBoolean(probability);
  }
}
