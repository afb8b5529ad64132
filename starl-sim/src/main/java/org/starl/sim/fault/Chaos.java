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
 * Draws fault plans. Each run of a campaign gets a random subset of the kinds of faults, and its own
 * mean times between faults and of faults: this finds more bugs than runs that all use every kind
 * (Groce et al., "Swarm testing", ISSTA 2012). Most runs that are long enough also have outages:
 * faults that outlast every timeout of the protocols, so that robots suspect each other, give each
 * other up, and meet again. In a quarter of these, outages are the only faults, so that progress is
 * required of the other robots. All faults have ended by the given time.
 */
final class Chaos {

  private static final double LEAST_MEAN_MS = 400;
  private static final double MOST_MEAN_MS = 6000;
  private static final double OUTAGES = 0.8;
  private static final int MOST_OUTAGES = 4;

  /** So many of the runs with outages have no other faults. */
  private static final double QUIET = 0.25;

  private static final int MOST_QUIET_OUTAGES = 2;
  private static final long LEAST_LASTING_MS = 50;
  private static final long MOST_DROPOUT_MS = 1000;
  private static final String DROPOUT = "dropout(any)";

  /** By then each robot has its first fix, which it believes. */
  private static final long FIRST_FIX_MS = 1000;

  /** Bad fixes last longer than a motion waits, and end before wrong ones are believed. */
  private static final long LEAST_BAD_MS = 2500;

  private static final long MOST_BAD_MS = 10_000;

  private final Rng rng;
  private final long timeoutMs;
  private final long untilMs;
  private final List<Fault> faults = new ArrayList<>();

  private Chaos(Rng rng, long timeoutMs, long untilMs) {
    this.rng = rng;
    this.timeoutMs = timeoutMs;
    this.untilMs = untilMs;
  }

  static FaultPlan draw(
      Envelope envelope, boolean isSealed, int robots, long timeoutNs, long untilNs, Rng rng) {
    return envelope == Envelope.UNLOCATED
        ? drawUnlocated(isSealed, robots, timeoutNs, untilNs, rng)
        : drawLocated(envelope, isSealed, robots, timeoutNs, untilNs, rng);
  }

  /** Where fixes are wrong, no robot crashes or misses its first fix: it would believe a wrong one. */
  private static FaultPlan drawUnlocated(
      boolean isSealed, int robots, long timeoutNs, long untilNs, Rng rng) {
    boolean areWrong = rng.nextBoolean(0.5);
    Chaos bad = new Chaos(rng, timeoutNs / Time.NS_PER_MS, untilNs / Time.NS_PER_MS);
    bad.addBadFixes(areWrong);
    Envelope others = areWrong ? Envelope.SPATIAL : Envelope.PHYSICAL;
    drawLocated(others, isSealed, robots, timeoutNs, untilNs, rng).faults().stream()
        .filter(fault -> !areWrong || !fault.effect().name().equals("dropout"))
        .forEach(bad.faults::add);
    return new FaultPlan(bad.faults);
  }

  private static FaultPlan drawLocated(
      Envelope envelope, boolean isSealed, int robots, long timeoutNs, long untilNs, Rng rng) {
    Chaos chaos = new Chaos(rng, timeoutNs / Time.NS_PER_MS, untilNs / Time.NS_PER_MS);
    List<Supplier<String>> kinds = chaos.kinds(envelope, isSealed);
    if (kinds.isEmpty() || chaos.untilMs <= LEAST_LASTING_MS) {
      return FaultPlan.NONE;
    }
    List<Supplier<String>> some = new ArrayList<>(kinds);
    double share = 0.2 + 0.7 * rng.nextDouble();
    some.removeIf(kind -> !rng.nextBoolean(share));
    chaos.addFaults(some.isEmpty() ? kinds : some);
    if (chaos.mayHaveOutages() && rng.nextBoolean(OUTAGES)) {
      chaos.addOutages(envelope.hasCrashes());
    }
    if (isSealed && rng.nextBoolean(0.5)) {
      chaos.add(chaos.attacks().get(rng.nextInt(2)).get(), 0, chaos.untilMs);
    }
    if (drives(envelope) && rng.nextBoolean(0.3)) {
      // One at most: several would add up to more than geocasts allow for.
      chaos.add(fault("skew", "any", chaos.upTo(20) + "ms"), 0, chaos.untilMs);
    }
    if (chaos.faults.isEmpty()) {
      chaos.add(kinds.get(0).get(), 0, chaos.untilMs / 2);
    }
    if (envelope == Envelope.MORTAL && rng.nextBoolean(0.7)) {
      chaos.addPermanentCrashes((robots - 1) / 2);
    }
    return new FaultPlan(chaos.faults);
  }

  private static boolean drives(Envelope envelope) {
    return envelope == Envelope.SPATIAL || envelope == Envelope.PHYSICAL;
  }

  private void addFaults(List<Supplier<String>> kinds) {
    double meanGapMs = meanMs();
    double meanLastingMs = meanMs();
    // In some runs a fault lasts for the whole run, in most runs faults begin and end.
    if (rng.nextBoolean(0.3)) {
      add(network().get(rng.nextInt(network().size())).get(), 0, untilMs);
    }
    long atMs = Math.round(meanGapMs / 2 * rng.nextExponential());
    while (atMs < untilMs - LEAST_LASTING_MS) {
      long lastingMs = LEAST_LASTING_MS + Math.round(meanLastingMs * rng.nextExponential());
      String fault = kinds.get(rng.nextInt(kinds.size())).get();
      if (fault.equals(DROPOUT)) {
        lastingMs = Math.min(lastingMs, MOST_DROPOUT_MS);
      }
      add(fault, atMs, Math.min(untilMs, atMs + lastingMs));
      atMs += 1 + Math.round(meanGapMs * rng.nextExponential());
    }
  }

  /** One after another: two wrong shifts could add up to a small one, which no robot notices. */
  private void addBadFixes(boolean areWrong) {
    long atMs = FIRST_FIX_MS + rng.nextLong(0, MOST_BAD_MS);
    while (atMs + LEAST_BAD_MS <= untilMs) {
      long endMs = Math.min(untilMs, atMs + rng.nextLong(LEAST_BAD_MS, MOST_BAD_MS));
      String who = anyOr("all");
      add(areWrong ? fault("jump", who, rng.nextLong(5, 20) + "m") : absent(who), atMs, endMs);
      atMs = endMs + 1 + rng.nextLong(0, MOST_BAD_MS);
    }
  }

  private String absent(String who) {
    return isDrawn(0.5)
        ? fault("dropout", who)
        : fault("noise", who, rng.nextLong(2, 5) + "m", angle());
  }

  private boolean mayHaveOutages() {
    return timeoutMs > 0 && untilMs >= leastOutageMs();
  }

  private long leastOutageMs() {
    return timeoutMs + timeoutMs / 10;
  }

  private void addOutages(boolean mayCrash) {
    if (rng.nextBoolean(QUIET)) {
      // The other robots must go on meanwhile, within bounds, as no other fault is active.
      faults.clear();
      addOutages(mayCrash ? crashes() : outages(false), MOST_QUIET_OUTAGES);
    } else {
      addOutages(outages(mayCrash), MOST_OUTAGES);
    }
  }

  /** Faults of one robot or half of them, each longer than the longest timeout. */
  private void addOutages(List<Supplier<String>> kinds, int most) {
    int outages = 1 + rng.nextInt(most);
    for (int i = 0; i < outages; i++) {
      long lastingMs = leastOutageMs() + rng.nextLong(0, timeoutMs + timeoutMs / 2);
      lastingMs = Math.min(untilMs, lastingMs);
      // Some begin with the run, when robots register.
      long atMs = isDrawn(0.3) ? 0 : rng.nextLong(0, untilMs - lastingMs);
      add(kinds.get(rng.nextInt(kinds.size())).get(), atMs, atMs + lastingMs);
    }
  }

  private List<Supplier<String>> outages(boolean mayCrash) {
    List<Supplier<String>> kinds = new ArrayList<>();
    kinds.add(() -> fault("partition", anyOr("half")));
    // A deaf robot is drawn more often: others take it in, and give it up, and it knows of neither.
    kinds.add(() -> fault("partition", "all>any"));
    kinds.add(() -> fault("partition", "all>any"));
    kinds.add(() -> fault("partition", "any>all"));
    if (mayCrash) {
      kinds.addAll(crashes());
    }
    return kinds;
  }

  private List<Supplier<String>> crashes() {
    return List.of(
        () -> fault("crash", "any", unsynced()), () -> fault("crash", anyOr("half"), unsynced()));
  }

  /** A mean time of this run: short ones and long ones are equally likely. */
  private double meanMs() {
    return LEAST_MEAN_MS * StrictMath.pow(MOST_MEAN_MS / LEAST_MEAN_MS, rng.nextDouble());
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
  private List<Supplier<String>> kinds(Envelope envelope, boolean isSealed) {
    List<Supplier<String>> kinds = new ArrayList<>();
    if (envelope == Envelope.NONE) {
      return kinds;
    }
    kinds.addAll(network());
    if (envelope.hasCrashes()) {
      // Crashes are drawn more often than other faults, because they matter most for these
      // envelopes.
      kinds.addAll(crashes());
      kinds.add(() -> fault("forget", anyOr("half"), ms(1, 300), ms(1, 3000)));
      kinds.add(() -> fault("disk", anyOr("all"), isDrawn(0.7) ? ms(1, 100) : ms(100, 2000)));
    }
    if (isSealed) {
      kinds.addAll(attacks());
    }
    if (envelope == Envelope.LOGICAL
        || envelope == Envelope.MORTAL
        || envelope == Envelope.HOSTILE) {
      kinds.add(() -> fault("compute", anyOr("all"), ms(1, 20)));
      kinds.add(() -> fault("drift", "any", upTo(100_000) + "ppm"));
      kinds.add(() -> fault("skew", "any", ms(-1000, 1000)));
    }
    if (drives(envelope) || envelope == Envelope.MOVING) {
      kinds.add(() -> fault("drift", "any", upTo(200) + "ppm"));
      kinds.add(() -> fault("noise", anyOr("all"), Math.abs(upTo(19)) + 1 + "mm", angle()));
    }
    if (drives(envelope)) {
      kinds.add(() -> DROPOUT);
      kinds.add(() -> fault("slow", "any", percent(50, 100)));
      kinds.add(() -> "stuck(any)");
    }
    return kinds;
  }

  private List<Supplier<String>> attacks() {
    return List.of(
        () -> fault("forge", anyOr("all"), ms(5, 200)),
        () -> fault("replay", anyOr("all"), ms(5, 200)),
        () -> fault("flood", anyOr("all"), ms(5, 100)));
  }

  private List<Supplier<String>> network() {
    return List.of(
        () -> fault("loss", percent(5, 100), link()),
        () -> fault("burst", ms(200, 2000), ms(50, 1000), percent(50, 100), link()),
        () -> fault("delay", latency(), link()),
        () -> fault("duplicate", percent(5, 80), isDrawn(0.6) ? ms(1, 1000) : stale(), link()),
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

  /** Copies that outlast crashes, requests and terms, but not the time until the world is calm. */
  private String stale() {
    return ms(1000, 8000);
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

  /** From {@code -most} to {@code most}, in a third of the cases one of these two. */
  private long upTo(long most) {
    return Math.clamp(rng.nextLong(-3 * most, 3 * most) / 2, -most, most);
  }

  private String angle() {
    return Quantities.angleText(rng.nextLong(0, 20) / 1000.0);
  }

  private boolean isDrawn(double probability) {
    return rng.nextBoolean(probability);
  }
}
