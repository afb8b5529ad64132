package org.starl.spec;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.starl.geometry.Region;
import org.starl.id.RobotId;
import org.starl.trace.TraceEvent;

/**
 * A monitor that does not require some lemmas of some robots: it leaves out violations of these
 * lemmas that involve one of these robots, and says so in its {@link #exceptions}.
 */
public final class ExceptRobots implements Monitor {

  private final Monitor monitor;
  private final SortedSet<RobotId> robots;
  private final List<String> lemmas;
  private final String reason;

  /**
   * @param lemmas lemmas of {@code monitor}
   * @param reason why not, after "robots which": {@code drive at random}
   * @throws IllegalArgumentException if the monitor does not check one of the lemmas
   */
  public ExceptRobots(
      Monitor monitor, Collection<RobotId> robots, List<String> lemmas, String reason) {
    if (!monitor.lemmas().containsAll(lemmas)) {
      throw new IllegalArgumentException(lemmas + ": expected some of " + monitor.lemmas());
    }
    this.monitor = monitor;
    this.robots = Collections.unmodifiableSortedSet(new TreeSet<>(robots));
    this.lemmas = List.copyOf(lemmas);
    this.reason = reason;
  }

  @Override
  public List<String> lemmas() {
    return monitor.lemmas();
  }

  @Override
  public String description(String lemma) {
    return monitor.description(lemma);
  }

  @Override
  public List<String> progressLemmas() {
    return monitor.progressLemmas();
  }

  @Override
  public List<Monitor> companions() {
    return monitor.companions();
  }

  @Override
  public List<String> perRobotLemmas() {
    return monitor.perRobotLemmas();
  }

  @Override
  public Map<String, String> inapplicable() {
    return monitor.inapplicable();
  }

  @Override
  public Map<String, String> inPart() {
    return monitor.inPart();
  }

  /** One sentence; none without robots. */
  @Override
  public List<String> exceptions() {
    List<String> all = new ArrayList<>(monitor.exceptions());
    if (!robots.isEmpty()) {
      String names = robots.stream().map(RobotId::name).collect(Collectors.joining(" "));
      all.add("not required of " + names + ", which " + reason + ": " + String.join(" ", lemmas));
    }
    return all;
  }

  @Override
  public void observe(TraceEvent event, Report report) {
    monitor.observe(event, robots.isEmpty() ? report : new Filter(report));
  }

  @Override
  public void finish(long endNs, Report report) {
    monitor.finish(endNs, new Filter(report));
  }

  private final class Filter implements Report {
    private final Report report;

    Filter(Report report) {
      this.report = report;
    }

    private boolean isRequired(String lemma, List<RobotId> involved) {
      return !lemmas.contains(lemma) || Collections.disjoint(robots, involved);
    }

    @Override
    public void checked(String lemma) {
      report.checked(lemma);
    }

    @Override
    public void taken(String theory, Class<?> action) {
      report.taken(theory, action);
    }

    @Override
    public void evaluated(String theory, Class<?> action, String conjunct, boolean holds) {
      report.evaluated(theory, action, conjunct, holds);
    }

    @Override
    public void violated(String lemma, long timeNs, List<RobotId> involved, String detail) {
      if (isRequired(lemma, involved)) {
        report.violated(lemma, timeNs, involved, detail);
      }
    }

    @Override
    public void violatedIn(
        Region region, String lemma, long timeNs, List<RobotId> involved, String detail) {
      if (isRequired(lemma, involved)) {
        report.violatedIn(region, lemma, timeNs, involved, detail);
      }
    }

    @Override
    public void overdue(String lemma, long deadlineNs, List<RobotId> involved, String detail) {
      if (isRequired(lemma, involved)) {
        report.overdue(lemma, deadlineNs, involved, detail);
      }
    }
  }
}
