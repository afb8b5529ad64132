package org.starl.cli.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Measures;
import org.starl.cli.command.Colour;
import org.starl.cli.command.Json;
import org.starl.id.RobotId;
import org.starl.sim.Diagnosis;
import org.starl.sim.Failure;
import org.starl.sim.InjectedFault;
import org.starl.sim.SimResult;
import org.starl.spec.SpecReport;
import org.starl.spec.Specs;
import org.starl.time.Time;

/** A run's result as text and JSON. */
public final class Outcome {

  private static final int MOST_FAULTS = 20;

  private Outcome() {}

  static boolean isGood(SimResult result) {
    return result.isFinished() && result.spec().holds();
  }

  static List<String> lines(SimResult result, Measures measures) {
    List<String> lines = new ArrayList<>(faults(result));
    lines.add(
        "%s of %s %s finished in %s of simulated time; %s datagrams sent, %s copies lost"
            .formatted(
                measures.completed(),
                measures.came(),
                measures.tasks(),
                Time.text(result.endNs(), 1),
                result.network().sent(),
                result.network().lost()));
    if (result.spec().holds()) {
      if (result.spec().specs() != Specs.OFF) {
        lines.add(held(result.spec()));
      }
      lines.addAll(unknown(result.spec()));
    }
    lines.addAll(leftOut(result.spec()));
    lines.addAll(result.spec().exceptions());
    lines.addAll(complaints(result));
    return lines;
  }

  /** The part of a run's story that its faults are: a line for each. */
  static List<String> faults(SimResult result) {
    List<InjectedFault> faults = result.faults();
    List<String> lines = new ArrayList<>();
    int shown = Math.min(faults.size(), MOST_FAULTS);
    faults.subList(0, shown).forEach(fault -> lines.add("fault: " + fault));
    if (shown < faults.size()) {
      lines.add("and " + (faults.size() - shown) + " more faults");
    }
    return lines;
  }

  /** The line for a run without violations: the specifications that were checked. */
  public static String held(SpecReport spec) {
    return held(spec, Set.of());
  }

  /** The same without these, of which it is not decided. */
  public static String held(SpecReport spec, Set<String> undecided) {
    List<String> held = new ArrayList<>(spec.lemmas());
    held.removeAll(spec.neverChecked());
    held.removeAll(undecided);
    long checks = held.stream().mapToLong(spec::checks).sum();
    return "%s specifications held, in %s checks: %s"
        .formatted(held.size(), checks, String.join(" ", held));
  }

  /** A line for the specifications that {@code --specs} left out. */
  static List<String> leftOut(SpecReport spec) {
    return switch (spec.specs()) {
      case OFF -> List.of("specifications: not checked (--specs off)");
      case SAFETY -> List.of("not checked (--specs safety): " + String.join(" ", spec.leftOut()));
      case ALL -> List.of();
    };
  }

  /** Lines for the specifications without a check, or without one to the end, with the reasons. */
  public static List<String> unknown(SpecReport spec) {
    List<String> never = new ArrayList<>(spec.neverChecked());
    never.removeIf(lemma -> !spec.inapplicable(lemma).isEmpty());
    List<String> lines = new ArrayList<>();
    if (!never.isEmpty()) {
      lines.add("never checked: " + String.join(" ", never));
    }
    lines.addAll(inapplicable(spec));
    spec.inPart().forEach((lemma, why) -> lines.add("checked in part: " + lemma + ": " + why));
    return lines;
  }

  /** A line for each specification that does not apply, and was not checked. */
  public static List<String> inapplicable(SpecReport spec) {
    return spec.neverChecked().stream()
        .filter(lemma -> !spec.inapplicable(lemma).isEmpty())
        .map(lemma -> "does not apply: " + lemma + ": " + spec.inapplicable(lemma))
        .toList();
  }

  /** A line for each specification: its name, its sentence and its number of checks. */
  static List<String> explanations(SpecReport spec) {
    return spec.lemmas().stream()
        .map(lemma -> "  %s (%s)".formatted(explained(spec, lemma), checks(spec, lemma)))
        .toList();
  }

  private static String checks(SpecReport spec, String lemma) {
    return spec.neverChecked().contains(lemma) ? "never checked" : spec.checks(lemma) + " checks";
  }

  private static String explained(SpecReport spec, String lemma) {
    return lemma + ": " + spec.description(lemma);
  }

  /** A line for each problem; empty if the run was good. */
  static List<String> complaints(SimResult result) {
    List<String> lines = violations(result);
    lines.addAll(notFinished(result));
    return lines;
  }

  /** Lines for each violation, the first one with its reasons. */
  static List<String> violations(SimResult result) {
    List<String> lines = new ArrayList<>();
    SpecReport spec = result.spec();
    Failure failure = result.failure();
    for (SpecReport.Violation violation : spec.violations()) {
      boolean isFirst = violation.equals(spec.violations().getFirst());
      lines.add(Colour.bad("VIOLATED: " + violation));
      addReasons(lines, isFirst ? failure : null, result.diagnosis(violation));
    }
    spec.lemmas()
        .forEach(lemma -> {
          if (spec.violations(lemma) > 0 && !spec.description(lemma).isEmpty()) {
            lines.add("  " + explained(spec, lemma));
          }
        });
    return lines;
  }

  /** Which apps have not ended, and why; empty if all have. */
  static List<String> notFinished(SimResult result) {
    List<String> lines = new ArrayList<>();
    if (!result.isFinished()) {
      lines.add(Colour.bad("NOT FINISHED: " + result.unfinished()));
      addReasons(lines, result.spec().holds() ? result.failure() : null, result.diagnosis());
    }
    return lines;
  }

  /**
   * @param failure if it is the one that {@code diagnosis} is of; else null
   */
  private static void addReasons(
      List<String> lines, @Nullable Failure failure, Diagnosis diagnosis) {
    List<String> reasons = new ArrayList<>();
    if (failure == null) {
      reasons.addAll(diagnosis.lines());
    } else {
      reasons.addAll(failure.reasons());
      reasons.addAll(diagnosis.details());
    }
    reasons.forEach(line -> lines.add("  " + line));
  }

  static Map<String, Object> json(String app, SimResult result, Measures measures) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("app", app);
    json.put("seed", result.seed());
    json.put("behaviourSeed", result.behaviourSeed());
    json.put("good", isGood(result));
    json.put("end_s", Time.seconds(result.endNs()));
    json.put("events", result.events());
    json.put("came", measures.came());
    json.put("completed", measures.completed());
    json.putAll(measures.figures());
    json.put("unfinished", result.unfinished().stream().map(Object::toString).toList());
    json.put("cause", result.diagnosis().cause());
    json.put("waits", waits(result.diagnosis()));
    measures.counts().forEach((name, count) -> json.put(name.replaceAll("[: ]+", "_"), count));
    json.put("datagrams", result.network().sent());
    json.put("lost", result.network().lost());
    Map<String, Object> checks = new LinkedHashMap<>();
    result.spec().lemmas().forEach(lemma -> checks.put(lemma, result.spec().checks(lemma)));
    json.put("specs", result.spec().specs().toString());
    json.put("checks", checks);
    json.put("exceptions", result.spec().exceptions());
    json.put("violations", result.spec().violations().stream().map(Object::toString).toList());
    List<Map<String, Object>> overdue = new ArrayList<>();
    result
        .diagnoses()
        .forEach((violation, diagnosis) -> {
          if (violation.isOverdue()) {
            overdue.add(
                Json.object(
                    "violation",
                    violation.toString(),
                    "cause",
                    diagnosis.cause(),
                    "waits",
                    waits(diagnosis)));
          }
        });
    json.put("overdue", overdue);
    json.put("faults", result.faults().stream().map(Object::toString).toList());
    Failure failure = result.failure();
    if (failure != null) {
      json.put("failure", failure.fields());
    }
    return json;
  }

  /** Which robot waits for which. */
  private static Map<String, Object> waits(Diagnosis diagnosis) {
    Map<String, Object> json = new LinkedHashMap<>();
    diagnosis
        .graph()
        .waits()
        .forEach((robot, on) -> json.put(robot.name(), on.stream().map(RobotId::name).toList()));
    return json;
  }
}
