package org.starl.spec;

import static org.starl.time.Time.NS_PER_MS;
import static org.starl.time.Time.NS_PER_S;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.starl.geometry.Nowhere;
import org.starl.geometry.Region;
import org.starl.id.RobotId;

/**
 * The results of the monitors of one run: how often each lemma was checked, and its violations.
 * Lemmas are sorted by name, violations are in the order of their detection.
 */
public final class SpecReport implements Monitor.Report {

  /** Maximum number of violations kept per lemma; all are counted. */
  public static final int MAX_KEPT_PER_LEMMA = 100;

  /**
   * A violation of a lemma.
   *
   * @param robots the robots involved, in order
   * @param detail one line with the values
   * @param isOverdue whether a deadline has passed: the lemma requires progress
   * @param region the part of the floor that it concerns; often {@link Nowhere}
   */
  public record Violation(
      String lemma,
      long timeNs,
      List<RobotId> robots,
      String detail,
      boolean isOverdue,
      Region region) {

    public Violation {
      robots = List.copyOf(robots);
    }

    /** Without a deadline and a region. */
    public Violation(String lemma, long timeNs, List<RobotId> robots, String detail) {
      this(lemma, timeNs, robots, detail, false, new Nowhere());
    }

    /** {@code Exclusive violated at 12.345 s by bot1 bot2: both hold A}. */
    @Override
    public String toString() {
      StringBuilder line = new StringBuilder(lemma);
      line.append(" violated at ").append(timeNs / NS_PER_S).append('.');
      String ms = Long.toString(timeNs % NS_PER_S / NS_PER_MS);
      line.append("000", 0, 3 - ms.length()).append(ms).append(" s");
      if (!robots.isEmpty()) {
        line.append(" by");
        robots.forEach(robot -> line.append(' ').append(robot));
      }
      return line.append(": ").append(detail).toString();
    }
  }

  /**
   * What a run reached of a theory's automaton.
   *
   * @param action the class of the action
   * @param conjunct of its guard; empty if the action was taken
   * @param holds the value of the conjunct
   */
  public record Reached(String theory, Class<?> action, String conjunct, boolean holds) {}

  private static final class Tally {
    private long checks;
    private long violations;
  }

  private final Specs specs;
  private final SortedSet<String> leftOut = new TreeSet<>();

  // Looked up at every check; sorted for a reader.
  private final Map<String, Tally> tallies = new LinkedHashMap<>();
  private final Map<String, String> sentences = new TreeMap<>();
  private final List<Violation> violations = new ArrayList<>();
  private final Map<Reached, long[]> reached = new LinkedHashMap<>();
  private final List<String> exceptions = new ArrayList<>();
  private final SortedMap<String, String> inapplicable = new TreeMap<>();
  private final SortedMap<String, String> inPart = new TreeMap<>();

  public SpecReport() {
    this(Specs.ALL);
  }

  SpecReport(Specs specs) {
    this.specs = specs;
  }

  /** What the run was to check. */
  public Specs specs() {
    return specs;
  }

  /** Leaves out lemmas: what monitors report of them is not counted. */
  void leaveOut(Collection<String> lemmas) {
    leftOut.addAll(lemmas);
  }

  /** The lemmas that were left out because the {@link #specs} are not all. */
  public SortedSet<String> leftOut() {
    return Collections.unmodifiableSortedSet(leftOut);
  }

  @Override
  public void taken(String theory, Class<?> action) {
    evaluated(theory, action, "", true);
  }

  @Override
  public void evaluated(String theory, Class<?> action, String conjunct, boolean holds) {
    reached.computeIfAbsent(new Reached(theory, action, conjunct, holds), any -> new long[1])[0]++;
  }

  /** How often the theories' actions were taken, and the conjuncts of their guards true or false. */
  public Map<Reached, Long> reached() {
    Map<Reached, Long> counts = new LinkedHashMap<>();
    reached.forEach((what, count) -> counts.put(what, count[0]));
    return counts;
  }

  /** Sets the sentence that explains {@code lemma}; the first one that is not empty stays. */
  void describe(String lemma, String sentence) {
    if (!sentence.isEmpty()) {
      sentences.putIfAbsent(lemma, sentence);
    }
  }

  /** What {@code lemma} says, as its monitor describes it; empty if it does not. */
  public String description(String lemma) {
    return sentences.getOrDefault(lemma, "");
  }

  /** Adds the {@link Monitor#exceptions} of a monitor. */
  void except(List<String> lines) {
    exceptions.addAll(lines);
  }

  /** The robots of which a lemma is not required, and why: a line for each group; often none. */
  public List<String> exceptions() {
    return Collections.unmodifiableList(exceptions);
  }

  /** Adds a lemma of the {@link Monitor#inapplicable} of a monitor. */
  void exempt(String lemma, String reason) {
    inapplicable.put(lemma, reason);
  }

  /** The reason why runs like this one never check {@code lemma}; empty if there is none. */
  public String inapplicable(String lemma) {
    return inapplicable.getOrDefault(lemma, "");
  }

  /** Adds a lemma of the {@link Monitor#inPart} of a monitor. */
  void inPart(String lemma, String why) {
    inPart.put(lemma, why);
  }

  /** The lemmas that were not checked to the end of the run, each with when and why. */
  public SortedMap<String, String> inPart() {
    return Collections.unmodifiableSortedMap(inPart);
  }

  /** The lemmas without a check, applicable or not: nothing is known of them. */
  public List<String> neverChecked() {
    List<String> lemmas = new ArrayList<>();
    new TreeMap<>(tallies)
        .forEach((lemma, tally) -> {
          if (tally.checks == 0 && tally.violations == 0) {
            lemmas.add(lemma);
          }
        });
    return lemmas;
  }

  /** Adds lemmas that must be in the report even if they are never checked. */
  public void expect(Collection<String> lemmas) {
    lemmas.stream().filter(lemma -> !leftOut.contains(lemma)).forEach(this::tally);
  }

  @Override
  public void checked(String lemma) {
    if (!leftOut.contains(lemma)) {
      tally(lemma).checks++;
    }
  }

  @Override
  public void violated(String lemma, long timeNs, List<RobotId> robots, String detail) {
    add(new Violation(lemma, timeNs, robots, detail));
  }

  @Override
  public void violatedIn(
      Region region, String lemma, long timeNs, List<RobotId> robots, String detail) {
    add(new Violation(lemma, timeNs, robots, detail, false, region));
  }

  @Override
  public void overdue(String lemma, long deadlineNs, List<RobotId> robots, String detail) {
    add(new Violation(lemma, deadlineNs, robots, detail, true, new Nowhere()));
  }

  private void add(Violation violation) {
    if (leftOut.contains(violation.lemma())) {
      return;
    }
    Tally tally = tally(violation.lemma());
    tally.violations++;
    if (tally.violations <= MAX_KEPT_PER_LEMMA) {
      violations.add(violation);
    }
  }

  /** Whether no violation was reported. */
  public boolean holds() {
    return violations.isEmpty();
  }

  /** The lemmas that were expected, checked or violated, sorted. */
  public List<String> lemmas() {
    return List.copyOf(new TreeMap<>(tallies).keySet());
  }

  /** Number of checks of one of the {@link #lemmas}; another name is refused. */
  public long checks(String lemma) {
    return known(lemma).checks;
  }

  /** Number of violations of one of the {@link #lemmas}, kept or not; another name is refused. */
  public long violations(String lemma) {
    return known(lemma).violations;
  }

  private Tally known(String lemma) {
    Tally tally = tallies.get(lemma);
    if (tally == null) {
      throw new IllegalArgumentException("lemma " + lemma + ": expected one of " + lemmas());
    }
    return tally;
  }

  /** The kept violations, in the order of their detection. */
  public List<Violation> violations() {
    return Collections.unmodifiableList(violations);
  }

  private Tally tally(String lemma) {
    Tally known = tallies.get(lemma); // almost always there
    return known != null ? known : tallies.computeIfAbsent(lemma, name -> new Tally());
  }

  /** One line per lemma, then one line per kept violation; no line end after the last. */
  @Override
  public String toString() {
    List<String> lines = new ArrayList<>();
    new TreeMap<>(tallies).forEach((lemma, tally) -> lines.add(lemma + ": " + describe(tally)));
    violations.forEach(violation -> lines.add(violation.toString()));
    return String.join("\n", lines);
  }

  private static String describe(Tally tally) {
    String checks = tally.checks == 1 ? "1 check" : tally.checks + " checks";
    if (tally.violations == 0) {
      return tally.checks == 0 ? "never checked" : checks + ", held";
    }
    return checks + ", violated " + (tally.violations == 1 ? "once" : tally.violations + " times");
  }
}
