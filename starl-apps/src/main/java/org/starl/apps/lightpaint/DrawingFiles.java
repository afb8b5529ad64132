package org.starl.apps.lightpaint;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.input.BadInput;
import org.starl.input.TextFile;

/** Reads drawings from files, by their suffix. */
final class DrawingFiles {

  private static final String EXPECTED = "expected a drawing, NAME.svg or NAME.wpt";

  private DrawingFiles() {}

  /**
   * A drawing, its lines in mm.
   *
   * @param reading of a {@code .wpt} drawing, only the scale is used, for its lines' widths
   * @throws BadInput if the file cannot be read or has no line to paint
   */
  static SvgDrawing read(Path path, SvgDrawing.Reading reading) {
    String file = path.toString();
    boolean isSvg = file.toLowerCase(Locale.ROOT).endsWith(".svg");
    if (!isSvg && !file.toLowerCase(Locale.ROOT).endsWith(".wpt")) {
      throw new BadInput(file + ": " + EXPECTED);
    }
    byte[] bytes = TextFile.bytes(path, EXPECTED);
    SvgDrawing drawing =
        isSvg
            ? SvgDrawing.read(file, bytes, reading)
            : new SvgDrawing(
                WptDrawing.read(file, TextFile.decode(file, bytes, EXPECTED), reading.mmPerUnit()),
                List.of());
    if (drawing.lines().isEmpty()) {
      String why = String.join("; ", drawing.notes());
      throw new BadInput(
          file
              + ": no line has a stroke: expected at least one line to paint"
              + (why.isEmpty() ? "" : " (" + why + ")"));
    }
    return drawing;
  }
}
