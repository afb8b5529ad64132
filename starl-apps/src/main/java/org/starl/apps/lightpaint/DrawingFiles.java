package org.starl.apps.lightpaint;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.input.BadInput;

/** Reads drawings from files, by the ending of their names. */
final class DrawingFiles {

  private static final String EXPECTED = "expected a drawing, NAME.svg or NAME.wpt";

  private DrawingFiles() {}

  /**
   * The lines of a drawing, in mm.
   *
   * @param mmPerUnit of an SVG, and of widths
   * @param flatnessMm no point of a curve is farther from the lines that take its place
   * @throws BadInput if it cannot be read, or nothing in it is to be painted
   */
  static List<Line> read(Path path, double mmPerUnit, double flatnessMm) {
    String name = path.toString().toLowerCase(Locale.ROOT);
    if (!name.endsWith(".svg") && !name.endsWith(".wpt")) {
      throw new BadInput(path + ": " + EXPECTED);
    }
    byte[] bytes = bytes(path);
    List<Line> lines =
        name.endsWith(".svg")
            ? SvgDrawing.read(path.toString(), bytes, mmPerUnit, flatnessMm)
            : WptDrawing.read(
                path.toString(), new String(bytes, StandardCharsets.UTF_8), mmPerUnit);
    if (lines.isEmpty()) {
      throw new BadInput(path + ": has no line with a stroke: expected something to paint");
    }
    return lines;
  }

  private static byte[] bytes(Path path) {
    if (!Files.isRegularFile(path)) {
      throw new BadInput(path + ": no such file; " + EXPECTED);
    }
    try {
      return Files.readAllBytes(path);
    } catch (IOException e) {
      throw new BadInput(path + ": cannot be read (" + e + "); " + EXPECTED);
    }
  }
}
