package org.starl.cli.request;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.starl.apps.Demos;
import org.starl.cli.command.OptionValues;
import org.starl.input.BadInput;
import org.starl.launch.DeploymentFile;
import org.starl.sim.Setting;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The options of every command that runs an app: texts until {@link #request} parses them. */
public class RunOptions {

  private String name = "";

  /** With the app, which every command but {@code serve} needs. */
  public static final class OfApp extends RunOptions {
    @Parameters(
        index = "0",
        paramLabel = "APP|PRIMITIVE|FILE.yaml",
        description =
            "An app or a primitive ('starl list' names them), or a scenario file. 'starl record'"
                + " also takes a trace.")
    void app(String text) {
      named(text);
    }
  }

  @Option(
      names = "--fault",
      paramLabel = "FAULT",
      description =
          "A fault to inject: 'crash(bot2,at=12s,restart=5s)', 'loss(0.9,from=bot1)'; 'starl list'"
              + " shows all kinds. May be repeated.")
  private List<String> faults = new ArrayList<>();

  @Option(
      names = "--set",
      paramLabel = "KEY=VALUE",
      description =
          "Any other setting or parameter; 'starl list' shows them with their defaults. May be"
              + " repeated.")
  private List<String> settings = new ArrayList<>();

  @Option(
      names = "--as-deployed",
      paramLabel = "FILE",
      description =
          "Simulate with the limits and errors of a deployment file; if it is for this app, also with"
              + " its parameters and number of robots. Other options replace them.")
  private @Nullable String asDeployed;

  private final Map<Setting<?>, String> given = new LinkedHashMap<>();

  @Option(
      names = "--robots",
      paramLabel = "N",
      description = "Number of robots (default: the app's).")
  void robots(@Nullable String text) {
    give(Setting.ROBOTS, text);
  }

  @Option(
      names = "--for",
      paramLabel = "TIME",
      description =
          "Simulated time after which the run ends, such as 60s (default: the app's own limit, or"
              + " 1200s).")
  void duration(@Nullable String text) {
    give(Setting.DURATION, text);
  }

  @Option(
      names = "--loss",
      paramLabel = "P",
      description = "Probability from 0 to 1 that a datagram is lost, for each recipient.")
  void loss(@Nullable String text) {
    give(Setting.MESSAGE_LOSS, text);
  }

  @Option(
      names = "--delay",
      paramLabel = "TIME",
      description =
          "Delay of a datagram: 100ms, 'uniform(10ms,20ms)', 'normal(100ms,20ms)',"
              + " 'exponential(50ms)'.")
  void delay(@Nullable String text) {
    give(Setting.MESSAGE_DELAY, text);
  }

  @Option(
      names = "--gps-noise",
      paramLabel = "LENGTH",
      description = "Largest error of a position fix, such as 20mm.")
  void gpsNoise(@Nullable String text) {
    give(Setting.POSITION_NOISE, text);
  }

  @Option(
      names = "--ideal",
      description =
          "Ideal motion: robots turn instantly, drive exactly and pass through obstacles.")
  void ideal(boolean on) {
    give(Setting.IDEAL_MOTION, on ? "true" : null);
  }

  @Option(
      names = "--chaos",
      description =
          "Inject random faults of the kinds that the app must tolerate, drawn from the seed. They"
              + " occur in the first part of the run (its length: '--set chaosFor=60s'); after that"
              + " everything works.")
  void chaos(boolean on) {
    give(Setting.CHAOS, on ? "true" : null);
  }

  private void give(Setting<?> setting, @Nullable String text) {
    if (text != null) {
      given.put(setting, text);
    }
  }

  /** Sets the app, primitive or file. */
  public final void named(String text) {
    name = text;
  }

  /** The app, primitive or file, as the user wrote it; empty if there is none. */
  public final String name() {
    return name;
  }

  /**
   * The keys and values of {@code --set}.
   *
   * @throws BadInput for a key that was given twice, also by an option of its own
   */
  public final Map<String, String> sets() {
    Map<String, String> sets = OptionValues.named("--set", settings, "KEY=VALUE");
    for (Setting<?> setting : given.keySet()) {
      if (sets.containsKey(setting.key())) {
        throw new BadInput(
            "--set "
                + setting.key()
                + ": "
                + option(setting)
                + " gives it, too; expected one of them");
      }
    }
    return sets;
  }

  /**
   * Checks the options for a trace: no option can change its run.
   *
   * @throws BadInput with the first given option
   */
  public final void requireNoneFor(String trace) {
    List<String> options = new ArrayList<>();
    given.keySet().forEach(setting -> options.add(option(setting)));
    faults.forEach(fault -> options.add("--fault"));
    settings.forEach(text -> options.add("--set"));
    if (asDeployed != null) {
      options.add("--as-deployed");
    }
    if (!options.isEmpty()) {
      throw new BadInput(options.get(0) + " cannot be used with a trace: " + trace);
    }
  }

  /**
   * The request of the scenario file, if any, and these options, for an app of {@code demos}.
   * A deployment replaces the file's values, options replace both; {@code --fault} adds
   * to the file's faults.
   *
   * @throws BadInput naming the option or the file's line, the value and the expected form
   */
  public final RunRequest request(Demos demos) {
    boolean isFile = ScenarioFile.isScenario(name);
    ScenarioFile file = isFile ? ScenarioFile.read(name) : ScenarioFile.ofApp(name);
    RunRequest.Builder request = file.request(demos);
    if (asDeployed != null) {
      DeployedApp.simulated(DeploymentFile.read(asDeployed), file.app(), request);
    }
    faults.forEach(request::fault);
    given.forEach((setting, text) -> request.set(option(setting) + ": ", setting.key(), text));
    sets().forEach((key, text) -> request.set("--set: ", key, text));
    return request.build();
  }

  private static String option(Setting<?> setting) {
    return Objects.requireNonNull(RunRequest.OPTIONS.get(setting));
  }
}
