package org.starl.launch;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Pose;
import org.starl.input.BadInput;
import org.starl.input.FailureText;
import org.starl.input.TextFile;
import org.starl.platform.Clock;
import org.starl.robot.optitrack.Axes;
import org.starl.robot.optitrack.PoseSource;
import org.starl.robot.optitrack.PoseSource.Body;
import org.starl.robot.optitrack.PoseSource.Snapshot;
import org.starl.time.Time;

/**
 * The rigid bodies of a take, as Motive exports it: CSV of format 1.2x, rotations as quaternions. Other columns (markers, bones) are
 * skipped. A body that has no pose in a frame, or does not stand on the floor, is not tracked there. Immutable.
 *
 * @param frames at least one; times in ns, from 0 on
 * @param framesPerS the mean rate, from 1 to 1000
 */
public record Take(List<Snapshot> frames, int framesPerS) {

  private static final String EXPECTED = "expected a take that Motive has exported as CSV";
  private static final String TIME = "Time (Seconds)";
  private static final double LONGEST_S = 1e6;
  private static final int LONGEST_LINE = 1_000_000;
  private static final int MOST_PER_S = 1000;
  private static final Map<String, Double> M_PER_UNIT =
      Map.of("Meters", 1.0, "Centimeters", 0.01, "Millimeters", 0.001);

  /** The columns of a body that it must have; its mean error may follow. */
  private static final List<String> COLUMNS =
      List.of(
          "Rotation X",
          "Rotation Y",
          "Rotation Z",
          "Rotation W",
          "Position X",
          "Position Y",
          "Position Z");

  private static final int ERROR = COLUMNS.size();

  public Take {
    frames = List.copyOf(frames);
  }

  /**
   * Reads a take.
   *
   * @param axes how the take's coordinates become ours
   * @throws BadInput if it is no such file, or a row is wrong
   */
  public static Take read(Path file, Axes axes) {
    try (var in = TextFile.open(file, EXPECTED);
        var lines =
            new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8.newDecoder()))) {
      return new Reader(file.toString(), lines, axes).take();
    } catch (IOException e) {
      throw new BadInput(file + ": cannot be read (" + FailureText.of(e) + "); " + EXPECTED);
    }
  }

  /** The names of the rigid bodies. */
  public List<String> names() {
    return frames.get(0).bodies().stream().map(Body::name).toList();
  }

  /** From the first frame to the last. */
  public long lengthNs() {
    return frames.get(frames.size() - 1).atNs();
  }

  /** Number of the frames in which {@code body} is tracked; 0 for an unknown one. */
  public long tracked(String body) {
    return frames.stream()
        .filter(frame ->
            frame.bodies().stream().anyMatch(each -> each.isTracked() && each.name().equals(body)))
        .count();
  }

  /**
   * Plays it once: at each time the newest frame, before and after it the first and the last one, as new ones.
   *
   * @param startNs time of the first frame on {@code clock}
   */
  public PoseSource from(long startNs, Clock clock) {
    int[] next = {0};
    return () -> {
      long nowNs = clock.nowNs();
      while (next[0] < frames.size() - 1 && startNs + frames.get(next[0] + 1).atNs() <= nowNs) {
        next[0]++;
      }
      Snapshot frame = frames.get(next[0]);
      boolean isPlaying = nowNs >= startNs && nowNs < startNs + lengthNs();
      return new Snapshot(isPlaying ? startNs + frame.atNs() : nowNs, frame.bodies());
    };
  }

  /** Reads the rows of one file. */
  private static final class Reader {
    private final String file;
    private final BufferedReader lines;
    private final Axes axes;
    private int line;

    Reader(String file, BufferedReader lines, Axes axes) {
      this.file = file;
      this.lines = lines;
      this.axes = axes;
    }

    Take take() throws IOException {
      List<String> header = row();
      if (header == null || !header.get(0).equals("Format Version")) {
        throw wrong("begins with another word than 'Format Version'; " + EXPECTED);
      }
      String unit = setting(header, "Length Units");
      Double metres = M_PER_UNIT.get(unit);
      if (metres == null) {
        throw wrong(
            "Length Units is "
                + BadInput.quote(unit)
                + "; expected Meters, Centimeters or Millimeters");
      }
      String rotation = setting(header, "Rotation Type");
      if (!rotation.equals("Quaternion")) {
        throw wrong(
            "Rotation Type is " + BadInput.quote(rotation) + "; expected Quaternion: export it so");
      }
      List<List<String>> titles = new ArrayList<>();
      List<String> axisRow = row();
      while (axisRow != null && !axisRow.get(0).equals("Frame")) {
        titles.add(axisRow);
        axisRow = row();
      }
      titles.removeIf(each -> each.stream().allMatch(String::isEmpty));
      // Format 1.21 and older have the short title.
      int time = axisRow == null ? -1 : Math.max(axisRow.indexOf(TIME), axisRow.indexOf("Time"));
      if (axisRow == null || time < 0 || titles.size() < 3) {
        throw wrong("has no row of titles with 'Frame' and '" + TIME + "'; " + EXPECTED);
      }
      return frames(columns(titles, axisRow), time, axisRow.size(), metres);
    }

    private static String setting(List<String> header, String key) {
      int at = header.indexOf(key);
      return cell(header, at < 0 ? header.size() : at + 1);
    }

    /** The columns of each rigid body, in the order of {@link #COLUMNS}; -1 for one that it lacks. */
    private Map<String, int[]> columns(List<List<String>> titles, List<String> axisRow) {
      Map<String, int[]> bodies = new LinkedHashMap<>();
      List<String> types = titles.get(0);
      for (int i = 0; i < types.size(); i++) {
        if (types.get(i).equals("Rigid Body")) {
          int[] columns =
              bodies.computeIfAbsent(
                  cell(titles.get(1), i),
                  name -> {
                    int[] none = new int[ERROR + 1];
                    Arrays.fill(none, -1);
                    return none;
                  });
          String property = cell(titles.get(titles.size() - 1), i);
          int known = COLUMNS.indexOf(property + " " + cell(axisRow, i));
          known = known < 0 && property.contains("Error") ? ERROR : known;
          if (known >= 0 && columns[known] >= 0) {
            throw wrong("two rigid bodies have the name " + BadInput.quote(cell(titles.get(1), i)));
          } else if (known >= 0) {
            columns[known] = i;
          }
        }
      }
      bodies.forEach((name, columns) -> {
        for (int i = 0; i < ERROR; i++) {
          if (columns[i] < 0) {
            throw wrong(
                "rigid body " + BadInput.quote(name) + " has no column '" + COLUMNS.get(i) + "'");
          }
        }
      });
      if (bodies.isEmpty()) {
        throw wrong("has no rigid body; expected columns of 'Rigid Body': export these, too");
      }
      return bodies;
    }

    private Take frames(Map<String, int[]> columns, int time, int width, double metres)
        throws IOException {
      List<Snapshot> frames = new ArrayList<>();
      Map<String, Body> last = new LinkedHashMap<>();
      columns.keySet().forEach(name -> last.put(name, body(name, new Pose(0, 0, 0), false, 0)));
      double firstS = 0;
      long atNs = -1;
      for (List<String> next = row(); next != null; next = row()) {
        List<String> row = next;
        if (row.stream().allMatch(String::isEmpty)) {
          continue;
        }
        for (int i = width; i < row.size(); i++) {
          if (!row.get(i).isEmpty()) {
            throw wrong(
                "column %s is %s; expected %s columns, as the titles have"
                    .formatted(i + 1, BadInput.quote(row.get(i)), width));
          }
        }
        double timeS = number(row, time);
        firstS = frames.isEmpty() ? timeS : firstS;
        long beforeNs = atNs;
        atNs = Math.round((timeS - firstS) * Time.NS_PER_S);
        if (atNs <= beforeNs || timeS - firstS > LONGEST_S) {
          throw wrong(
              TIME
                  + " is "
                  + BadInput.quote(cell(row, time))
                  + "; expected a later time than before it");
        }
        for (Map.Entry<String, int[]> each : columns.entrySet()) {
          last.computeIfPresent(
              each.getKey(), (name, before) -> body(row, each.getValue(), before, metres));
        }
        frames.add(new Snapshot(atNs, List.copyOf(last.values())));
      }
      if (frames.isEmpty()) {
        throw wrong("ends without a frame; " + EXPECTED);
      }
      double perS = atNs == 0 ? 1 : (frames.size() - 1) / (atNs / (double) Time.NS_PER_S);
      return new Take(frames, (int) Math.max(1, Math.min(MOST_PER_S, Math.round(perS))));
    }

    /** The body in this row; not tracked, where it was before, if its cells are empty. */
    private Body body(List<String> row, int[] columns, Body before, double metres) {
      if (Arrays.stream(columns, 0, ERROR).allMatch(column -> cell(row, column).isEmpty())) {
        return body(before.name(), before.pose(), false, 0);
      }
      double[] values = new double[ERROR];
      for (int i = 0; i < ERROR; i++) {
        values[i] = number(row, columns[i]) * (i < 4 ? 1 : metres);
      }
      Pose pose =
          axes.pose(values[4], values[5], values[6], values[0], values[1], values[2], values[3]);
      boolean hasError = columns[ERROR] >= 0 && !cell(row, columns[ERROR]).isEmpty();
      double errorMm = hasError ? 1000 * metres * number(row, columns[ERROR]) : 0;
      return body(
          before.name(), pose == null ? before.pose() : pose, pose != null, Math.max(0, errorMm));
    }

    private Body body(String name, Pose pose, boolean isTracked, double meanErrorMm) {
      try {
        return new Body(name, pose, isTracked, meanErrorMm);
      } catch (IllegalArgumentException e) {
        throw wrong("rigid body " + BadInput.quote(name) + ": expected a name of 1 to 255 bytes");
      }
    }

    private double number(List<String> row, int column) {
      String text = cell(row, column);
      double value;
      try {
        value = Double.parseDouble(text);
      } catch (NumberFormatException e) {
        value = Double.NaN;
      }
      if (!Double.isFinite(value)) {
        throw wrong(
            "column " + (column + 1) + " is " + BadInput.quote(text) + "; expected a number");
      }
      return value;
    }

    private static String cell(List<String> row, int column) {
      return column < row.size() ? row.get(column) : "";
    }

    /** The next line; null at the end. It is no longer than any of a take, for a file may have no line ends. */
    private @Nullable String nextLine() throws IOException {
      lines.mark(LONGEST_LINE + 1);
      for (int i = 0; i <= LONGEST_LINE; i++) {
        int c = lines.read();
        if (c < 0 || c == '\n' || c == '\r') {
          lines.reset();
          return lines.readLine();
        }
      }
      line++;
      throw wrong("is longer than " + LONGEST_LINE + " characters; " + EXPECTED);
    }

    /** The cells of the next line, without quotes and spaces around them; null at the end. */
    private @Nullable List<String> row() throws IOException {
      String text = nextLine();
      line++;
      if (text == null) {
        return null;
      }
      List<String> cells = new ArrayList<>();
      StringBuilder cell = new StringBuilder();
      boolean isQuoted = false;
      for (int i = 0; i <= text.length(); i++) {
        char c = i == text.length() ? ',' : text.charAt(i);
        if (c == '"') {
          isQuoted = !isQuoted;
        } else if (c == ',' && (!isQuoted || i == text.length())) {
          cells.add(cell.toString().strip());
          cell.setLength(0);
        } else if (c != '\uFEFF') {
          cell.append(c);
        }
      }
      return cells;
    }

    private BadInput wrong(String what) {
      return BadInput.at(file, line, what);
    }
  }
}
