package org.starl.robot.optitrack;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParseException;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.core.json.JsonReadFeature;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.jspecify.annotations.Nullable;
import org.starl.geometry.Angles;
import org.starl.geometry.Pose;
import org.starl.id.RobotId;

/**
 * Reads one line of the JSON feed: one object with the keys below, in any order, each at most once,
 * whose numbers are within bounds.
 */
final class JsonPoseParser {

  /** Longest line. */
  static final int MAX_BYTES = 1024;

  private static final int MAX_NUMBER_CHARS = 40;
  private static final String EXPECTED =
      "expected a JSON object, each key once, numbers of at most 40 digits";
  private static final double LARGEST_MM = 1e7;
  private static final double LARGEST_RAD = 1e3;
  private static final long LARGEST_NS = 4_000_000_000_000_000_000L;

  // No table of names: a sender could fill it.
  private static final JsonFactory JSON =
      JsonFactory.builder()
          .disable(JsonFactory.Feature.CANONICALIZE_FIELD_NAMES)
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS) // refused here, by their bounds
          .streamReadConstraints(
              StreamReadConstraints.builder()
                  .maxNumberLength(MAX_NUMBER_CHARS)
                  .maxNestingDepth(1)
                  .build())
          .build();

  private final JsonParser in;
  private @Nullable String robot;
  private @Nullable Long atNs;
  private double xMm = Double.NaN;
  private double yMm = Double.NaN;
  private double headingRad = Double.NaN;
  private double errorMm = Double.NaN;
  private double errorRad;

  private JsonPoseParser(JsonParser in) {
    this.in = in;
  }

  /** A pose, or null and the problem with the line. */
  record Result(@Nullable JsonPose pose, String problem) {}

  /** Reads {@code bytes[0..length)}; never throws. */
  static Result parse(byte[] bytes, int length) {
    if (length > MAX_BYTES) {
      return new Result(null, length + " bytes: expected at most " + MAX_BYTES);
    }
    // One character for each byte, whatever the encoding.
    String line = new String(bytes, 0, length, StandardCharsets.ISO_8859_1);
    try (JsonParser in = JSON.createParser(line)) {
      return new Result(new JsonPoseParser(in).object(), "");
    } catch (JsonProcessingException e) {
      int column = e.getLocation() == null ? 1 : e.getLocation().getColumnNr();
      String problem = e instanceof Wrong ? e.getOriginalMessage() : EXPECTED;
      return new Result(null, "column " + column + ": " + problem);
    } catch (IOException e) {
      throw new IllegalStateException("reading a text from memory", e);
    }
  }

  private JsonPose object() throws IOException {
    require(in.nextToken() == JsonToken.START_OBJECT, "'{'");
    while (in.nextToken() == JsonToken.FIELD_NAME) {
      entry(in.currentName());
    }
    require(in.nextToken() == null, "the end of the line");
    if (robot == null || atNs == null || Double.isNaN(xMm + yMm + headingRad + errorMm)) {
      throw wrong("robot, xMm, yMm, headingRad, errorMm and atNs");
    }
    return new JsonPose(
        robot, new Pose(xMm, yMm, Angles.normalize(headingRad)), errorMm, errorRad, atNs);
  }

  private void entry(String key) throws IOException {
    JsonToken value = in.nextToken();
    switch (key) {
      case "robot" -> {
        require(value == JsonToken.VALUE_STRING && RobotId.isValid(in.getText()), "a robot's name");
        robot = in.getText();
      }
      case "atNs" -> {
        require(value == JsonToken.VALUE_NUMBER_INT, "a whole number");
        long ns = in.getLongValue();
        require(ns >= -LARGEST_NS && ns <= LARGEST_NS, "at most " + LARGEST_NS);
        atNs = ns;
      }
      case "xMm" -> xMm = number(-LARGEST_MM, LARGEST_MM);
      case "yMm" -> yMm = number(-LARGEST_MM, LARGEST_MM);
      case "headingRad" -> headingRad = number(-LARGEST_RAD, LARGEST_RAD);
      case "errorMm" -> errorMm = number(0, LARGEST_MM);
      case "errorRad" -> errorRad = number(0, LARGEST_RAD);
      default -> throw wrong("a known key");
    }
  }

  private double number(double least, double most) throws IOException {
    String expected = "a number from " + least + " to " + most;
    require(in.currentToken().isNumeric(), expected);
    double value = in.getDoubleValue();
    require(value >= least && value <= most, expected);
    return value;
  }

  private void require(boolean holds, String expected) throws IOException {
    if (!holds) {
      throw wrong(expected);
    }
  }

  private Wrong wrong(String expected) {
    return new Wrong(in, expected);
  }

  /** An error that is found here, not by the library: its message is for users. */
  private static final class Wrong extends JsonParseException {

    private static final long serialVersionUID = 1;

    Wrong(JsonParser in, String expected) {
      super(in, "expected " + expected);
    }
  }
}
