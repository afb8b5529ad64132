package org.starl.apps.lightpaint;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.starl.apps.lightpaint.logic.Line;
import org.starl.apps.lightpaint.logic.Stroke;
import org.starl.apps.lightpaint.logic.Strokes;
import org.starl.apps.lightpaint.view.SvgDrawing;
import org.starl.geometry.Point;
import org.starl.input.BadInput;

/** Drawings from files. */
class DrawingFilesTest {

  private static final SvgDrawing.Reading READING = new SvgDrawing.Reading(5, false, 5, false);

  @Test
  void allOriginalDrawingsAreCutIntoStrokes() {
    List<String> found = new ArrayList<>();
    for (String name : OriginalDrawings.NAMES) {
      List<Line> lines =
          DrawingFiles.read(OriginalDrawings.folder().resolve(name), READING).lines();
      List<Stroke> strokes = Strokes.of(lines, 10, 1200);
      double linesMm = lines.stream().mapToDouble(line -> line.path().lengthMm()).sum();
      double strokesMm = strokes.stream().mapToDouble(stroke -> stroke.path().lengthMm()).sum();
      found.add(name + " " + lines.size() + " " + strokes.size());
      assertThat(strokesMm).as(name).isLessThanOrEqualTo(linesMm + 10 * lines.size());
      assertThat(strokes).as(name).allMatch(stroke -> stroke.path().lengthMm() < 1203);
      for (Line line : lines) {
        for (double mm = 0; mm <= line.path().lengthMm(); mm += 5) {
          Point place = line.path().at(mm);
          assertThat(strokes)
              .as("%s at %s", name, place)
              .anyMatch(stroke -> stroke.path().distanceMm(place) <= 11);
        }
      }
    }
    assertThat(found).contains("hi.svg 6 9");
  }

  @Test
  void filesThatAreNoDrawingsAreRefused(@TempDir Path folder) throws IOException {
    Path missing = folder.resolve("missing.svg");
    assertThatThrownBy(() -> DrawingFiles.read(missing, READING))
        .isInstanceOf(BadInput.class)
        .hasMessage(missing + ": no such file; expected a drawing, NAME.svg or NAME.wpt");
    assertThatThrownBy(() -> DrawingFiles.read(folder.resolve("a.png"), READING))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("expected a drawing, NAME.svg or NAME.wpt");
    Path empty = Files.writeString(folder.resolve("empty.wpt"), "// nothing\n");
    assertThatThrownBy(() -> DrawingFiles.read(empty, READING))
        .isInstanceOf(BadInput.class)
        .hasMessageContaining("no line has a stroke");
  }
}
