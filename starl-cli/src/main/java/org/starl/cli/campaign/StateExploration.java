package org.starl.cli.campaign;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.starl.cli.command.BaseCommand;
import org.starl.cli.command.ExitStatus;
import org.starl.cli.command.Json;
import org.starl.cli.command.OptionValues;
import org.starl.cli.command.ProgressLine;
import org.starl.input.BadInput;
import org.starl.primitives.agreement.SynodStates;
import org.starl.primitives.barrier.BarrierStates;
import org.starl.primitives.election.ElectionStates;
import org.starl.primitives.exhaustive.StateSearch;
import org.starl.primitives.exhaustive.StateSpace;
import org.starl.primitives.exhaustive.StateSpace.Bound;
import org.starl.primitives.geocast.GeocastStates;
import org.starl.primitives.mutex.MutexStates;
import org.starl.primitives.paths.TubeStates;
import org.starl.primitives.registration.RegistrationStates;
import org.starl.time.Time;
import picocli.CommandLine.Model.OptionSpec;

/** {@code starl explore PRIMITIVE --strategy states}: all states of a protocol's code. */
final class StateExploration {

  static final String STRATEGY = "states";
  static final int MOST_STATES = 100_000_000;

  private static final List<StateSpace> SPACES =
      List.of(
          MutexStates.SPACE,
          SynodStates.SPACE,
          BarrierStates.SPACE,
          ElectionStates.SPACE,
          RegistrationStates.SPACE,
          GeocastStates.SPACE,
          TubeStates.SPACE);
  private static final List<String> OWN_OPTIONS = List.of("--robots", "--crashes");
  private static final Set<String> OPTIONS =
      Set.of("--strategy", "--states", "--set", "--json", "--stacktrace", "--robots", "--crashes");

  private final StateSpace space;
  private final Map<String, Integer> bounds = new LinkedHashMap<>();

  /**
   * Reads the bounds.
   *
   * @param given the options of the command line
   * @param sets the keys and values of {@code --set}
   * @throws BadInput if an option or bound means nothing here
   */
  StateExploration(String primitive, List<OptionSpec> given, Map<String, String> sets) {
    space = space(primitive);
    space.bounds().forEach(bound -> bounds.put(bound.name(), bound.usual()));
    for (OptionSpec option : given) {
      String name = option.longestName();
      if (!OPTIONS.contains(name)) {
        throw new BadInput(name + " cannot be used with --strategy " + STRATEGY);
      }
      if (OWN_OPTIONS.contains(name)) {
        bound(name, name.substring(2), option.originalStringValues().getLast());
      }
    }
    sets.forEach((key, value) -> bound("--set " + key, key, value));
  }

  private static StateSpace space(String primitive) {
    return SPACES.stream()
        .filter(each -> each.name().equals(primitive))
        .findFirst()
        .orElseThrow(() ->
            new BadInput(
                "--strategy %s: %s: expected one of %s"
                    .formatted(
                        STRATEGY,
                        BadInput.quote(primitive),
                        SPACES.stream().map(StateSpace::name).toList())));
  }

  private void bound(String option, String name, String value) {
    List<Bound> own =
        space.bounds().stream()
            .filter(each -> !OWN_OPTIONS.contains("--" + each.name()) || option.equals("--" + name))
            .toList();
    Bound bound =
        own.stream()
            .filter(each -> each.name().equals(name))
            .findFirst()
            .orElseThrow(() -> new BadInput(option + ": no such bound; expected " + told(own)));
    bounds.put(name, OptionValues.whole(option, value, bound.least(), bound.most()));
  }

  private static String told(List<Bound> bounds) {
    List<String> told = new ArrayList<>();
    for (Bound each : bounds) {
      told.add("%s=%d..%d (%s)".formatted(each.name(), each.least(), each.most(), each.meaning()));
    }
    return "one of " + String.join(", ", told);
  }

  /** Visits the states and prints what was found; returns the exit status. */
  int run(int mostStates, boolean isJson, BaseCommand command) {
    PrintWriter out = command.out();
    PrintWriter err = command.err();
    ProgressLine progress = command.progress("states");
    StateSearch.Outcome outcome =
        space
            .search()
            .apply(name -> Objects.requireNonNull(bounds.get(name), name))
            .run(mostStates, states -> progress.show(states, mostStates));
    progress.end();
    if (isJson) {
      out.println(Json.line(summary(outcome)));
    } else {
      lines(outcome).forEach(out::println);
      double seconds = Time.seconds(progress.elapsedNs());
      err.println("%.1f s, %,.0f steps a second".formatted(seconds, outcome.steps() / seconds));
    }
    return outcome.violation().isEmpty() ? ExitStatus.GOOD : ExitStatus.VIOLATED;
  }

  private List<String> lines(StateSearch.Outcome outcome) {
    List<String> of = new ArrayList<>();
    bounds.forEach((name, value) -> of.add(name + " " + value));
    List<String> story = outcome.violation();
    String result =
        story.isEmpty()
            ? "no invariant is violated"
            : "violated after %d steps".formatted(story.size() - 1);
    List<String> lines = new ArrayList<>();
    lines.add(
        "%s (%s): %,d states%s, %,d steps; %s"
            .formatted(
                space.name(),
                String.join(", ", of),
                outcome.states(),
                outcome.isComplete() ? ", all that there are" : "",
                outcome.steps(),
                result));
    lines.add("  in %,d of them %s".formatted(outcome.reached(), space.goal()));
    for (int i = 0; i < story.size(); i++) {
      boolean isLast = i == story.size() - 1;
      lines.add("  " + (isLast ? "" : i + 1 + ". ") + story.get(i));
    }
    return lines;
  }

  private Map<String, Object> summary(StateSearch.Outcome outcome) {
    Map<String, Object> summary = new LinkedHashMap<>();
    summary.put("primitive", space.name());
    summary.putAll(bounds);
    summary.put("states", outcome.states());
    summary.put("reached", outcome.reached());
    summary.put("steps", outcome.steps());
    summary.put("complete", outcome.isComplete());
    summary.put("violation", outcome.violation());
    return summary;
  }
}
