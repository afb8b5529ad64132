package org.starl.sim.junit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.sim.SimulationPlan;
import org.starl.sim.check.RunArtifacts;

/**
 * The files that a failing test leaves: the trace of its first bad run and, with the viewer on the
 * class path, what {@link RunArtifacts} draws.
 *
 * @param folder for the files; created when needed
 * @param isShown whether to open the viewer
 */
record RunFiles(Path folder, boolean isShown) {

  /** The configuration parameter or system property that names the folder. */
  static final String FOLDER = "starl.artifacts";

  /** The configuration parameter or system property that opens the viewer on the first bad run. */
  static final String VIEW = "starl.view";

  /** The folder of the build's output: Gradle's if it is a Gradle build, otherwise Maven's. */
  static Path usualFolder() {
    boolean isGradle = Files.exists(Path.of("build")) && !Files.exists(Path.of("pom.xml"));
    return Path.of(isGradle ? "build" : "target", "starl");
  }

  /** The file for a trace; its folder exists. */
  Path trace(String test, long seed) throws IOException {
    Files.createDirectories(folder);
    return folder.resolve(test.replace('#', '.') + "-seed-" + seed + ".trace");
  }

  /** Draws the run of a trace; returns a line for each file. */
  List<String> draw(Path trace, SimulationPlan plan) throws IOException {
    Optional<RunArtifacts> viewer = RunArtifacts.installed();
    if (viewer.isEmpty()) {
      return List.of("for a picture, add org.starl:starl-sim-view to the test's dependencies");
    }
    List<String> lines = new ArrayList<>();
    for (Path file : viewer.get().write(trace, plan)) {
      lines.add("shown in: " + file);
    }
    return lines;
  }

  boolean canShow() {
    return RunArtifacts.installed().isPresent();
  }

  /**
   * Opens the viewer if the user asked for it, until it is closed.
   *
   * @param atNs the time to begin at; -1 if unknown
   */
  void showIfAsked(Path trace, SimulationPlan plan, long atNs)
      throws IOException, InterruptedException {
    if (isShown && canShow()) {
      RunArtifacts.installed().orElseThrow().show(trace, plan, Math.max(0, atNs));
    }
  }
}
