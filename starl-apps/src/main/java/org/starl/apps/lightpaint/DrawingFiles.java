package org.starl.apps.lightpaint;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

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
    byte[] bytes = TextFile.bytes(path, EXPECTED);
    List<Line> lines =
        name.endsWith(".svg")
            ? SvgDrawing.read(path.toString(), bytes, mmPerUnit, flatnessMm)
            : WptDrawing.read(
                path.toString(), TextFile.decode(path.toString(), bytes, EXPECTED), mmPerUnit);
    if (lines.isEmpty()) {
      throw new BadInput(path + ": has no line with a stroke: expected something to paint");
    }
    return lines;
  }
}
