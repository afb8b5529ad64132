package org.starl.apps.lightpaint;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The original StarL's drawings, where they are at hand. */
final class OriginalDrawings {

  static final List<String> NAMES =
      List.of(
          "benchmark.svg",
          "bike.svg",
          "bike.wpt",
          "box.svg",
          "collisiontest.svg",
          "cube.svg",
          "cube2.wpt",
          "curve_parse_test.svg",
          "gaptest.svg",
          "hi.svg",
          "kiva.svg",
          "kiva.wpt",
          "triforce.svg",
          "triforce.wpt");

  private OriginalDrawings() {}

  static Path folder() {
    // A relative property counts from the folder above the modules, as the default does.
    String shared = System.getProperty("starl.shared", "../../shared");
    Path folder = Path.of(shared, "data", "starl-original", "lightpaint");
    assumeTrue(Files.isDirectory(folder), "skipped: no folder " + folder + " (set -Dstarl.shared)");
    return folder;
  }
}
