package org.starl.sim.junit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.starl.sim.SimulationPlan;
import org.starl.sim.check.RunArtifacts;
import org.starl.trace.Vocabulary;

/**
 * The files that a failing test leaves: the trace of its first bad run and, with the viewer on the
 * class path, what {@link RunArtifacts} draws.
 *
 * @param folder for the files; created when needed
 * @param isShown whether to open the viewer
 */
record RunFiles(Path folder, boolean isShown) {

  /**
   * A bad run whose trace is written.
   *
   * @param vocabulary the shapes of the values in the trace
   * @param failure what was wrong
   */
  record BadRun(Path trace, Vocabulary vocabulary, SimulationPlan plan, String failure) {}

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
    return folder.resolve(beginning(test) + seed + ".trace");
  }

  /** Removes the files that earlier runs of a test left. */
  void removeOld(String test) {
    String[] files = folder.toFile().list((dir, file) -> file.startsWith(beginning(test)));
    try {
      for (String file : files == null ? new String[0] : files) {
        Files.deleteIfExists(folder.resolve(file));
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String beginning(String test) {
    return test.replace('#', '.') + "-seed-";
  }

  /** Draws a run; returns a line for each file. */
  List<String> draw(Optional<RunArtifacts> viewer, BadRun run) throws IOException {
    if (viewer.isEmpty()) {
      return List.of("for a picture, add org.starl:starl-sim-view to the test's dependencies");
    }
    List<String> lines = new ArrayList<>();
    for (Path file : viewer.get().write(run.trace, run.vocabulary, run.plan, run.failure)) {
      lines.add("shown in: " + file);
    }
    return lines;
  }

  /**
   * Opens the viewer if the user asked for it, until it is closed.
   *
   * @param atNs the time to begin at; -1 if unknown
   */
  void showIfAsked(Optional<RunArtifacts> viewer, BadRun run, long atNs)
      throws IOException, InterruptedException {
    if (isShown && viewer.isPresent()) {
      viewer.get().show(run.trace, run.vocabulary, run.plan, run.failure, Math.max(0, atNs));
    }
  }
}
