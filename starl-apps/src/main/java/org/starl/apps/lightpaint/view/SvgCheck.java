package org.starl.apps.lightpaint.view;

import java.io.ByteArrayInputStream;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.starl.input.BadInput;

/**
 * Checks that an SVG file can be read, and names file and line if not. A browser draws a broken path
 * up to the error, and so does JSVG; a robot must not.
 */
final class SvgCheck {

  // Possessive: a number is never split in two to make a pattern match.
  private static final String NUMBER =
      "[+-]?+(?:[0-9]++\\.?+[0-9]*+|\\.[0-9]++)(?:[eE][+-]?+[0-9]++)?+";

  private static final Pattern LENGTH =
      Pattern.compile("\\s*" + NUMBER + "(?:px|pt|pc|mm|cm|in|em|ex|rem|%)?\\s*");

  private static final Pattern BLANKS = Pattern.compile("[\\s,]*+");
  private static final Pattern NEXT_NUMBER = Pattern.compile("[\\s,]*+" + NUMBER);
  private static final Pattern NEXT_FLAG = Pattern.compile("[\\s,]*+[01]");

  /** The arguments of each command of a path, which may be repeated: n for number, f for flag. */
  private static final Map<Character, String> COMMANDS =
      Map.of(
          'M', "nn", 'L', "nn", 'T', "nn", 'H', "n", 'V', "n", 'C', "nnnnnn", 'S', "nnnn", 'Q',
          "nnnn", 'A', "nnnffnn", 'Z', "");

  private static final Map<String, List<String>> LENGTHS =
      Map.of(
          "line", List.of("x1", "y1", "x2", "y2"),
          "rect", List.of("x", "y", "width", "height", "rx", "ry"),
          "circle", List.of("cx", "cy", "r"),
          "ellipse", List.of("cx", "cy", "rx", "ry"),
          "svg", List.of("x", "y", "width", "height"),
          "use", List.of("x", "y", "width", "height"));

  private final String file;
  private final XMLStreamReader xml;

  private SvgCheck(String file, XMLStreamReader xml) {
    this.file = file;
    this.xml = xml;
  }

  /**
   * @throws BadInput if the file is no SVG, or a length, list of points or path cannot be read
   */
  static void check(String file, byte[] bytes) {
    XMLInputFactory factory = XMLInputFactory.newFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    try {
      XMLStreamReader xml = factory.createXMLStreamReader(new ByteArrayInputStream(bytes));
      new SvgCheck(file, xml).elements();
    } catch (XMLStreamException e) {
      int line = e.getLocation() == null ? 1 : Math.max(1, e.getLocation().getLineNumber());
      List<String> message = String.valueOf(e.getMessage()).lines().toList();
      String why = message.get(message.size() - 1).replaceFirst("^Message: ", "");
      throw new BadInput(file + ":" + line + ": is no XML (" + why + "): expected an SVG drawing");
    }
  }

  private void elements() throws XMLStreamException {
    boolean isRoot = true;
    while (xml.hasNext()) {
      if (xml.next() == XMLStreamConstants.START_ELEMENT) {
        if (isRoot && !xml.getLocalName().equals("svg")) {
          throw bad("<" + xml.getLocalName() + ">", "<svg>, of an SVG drawing");
        }
        isRoot = false;
        element(xml.getLocalName());
      }
    }
  }

  private void element(String name) {
    for (String attribute : LENGTHS.getOrDefault(name, List.of())) {
      String value = xml.getAttributeValue(null, attribute);
      if (value != null && !value.equals("auto") && !LENGTH.matcher(value).matches()) {
        throw bad(attribute + "=" + BadInput.quote(value), "a length, such as 12.5");
      }
    }
    String points = xml.getAttributeValue(null, "points");
    if (points != null) {
      points(points);
    }
    String path = xml.getAttributeValue(null, "d");
    if (path != null && name.equals("path")) {
      path(path);
    }
  }

  private void points(String points) {
    int at = end(BLANKS, points, 0);
    while (at < points.length()) {
      int afterX = end(NEXT_NUMBER, points, at);
      int afterY = afterX < 0 ? -1 : end(NEXT_NUMBER, points, afterX);
      if (afterY < 0) {
        throw bad("points=" + BadInput.quote(points), "numbers in pairs, such as 0,0 10,5");
      }
      at = end(BLANKS, points, afterY);
    }
  }

  private void path(String path) {
    String arguments = "";
    int start = end(BLANKS, path, 0);
    int at = start;
    while (at < path.length()) {
      char command = Character.toUpperCase(path.charAt(at));
      String ofCommand = COMMANDS.get(command);
      if (ofCommand == null && (arguments.isEmpty() || Character.isLetter(command))) {
        throw badPath(path, at, "a command: M L H V C S Q T A or Z");
      }
      if (at == start && command != 'M') {
        throw badPath(path, at, "M first");
      }
      if (ofCommand != null) {
        arguments = ofCommand;
        at++;
      }
      for (int i = 0; i < arguments.length(); i++) {
        boolean isFlag = arguments.charAt(i) == 'f';
        int next = end(isFlag ? NEXT_FLAG : NEXT_NUMBER, path, at);
        if (next < 0) {
          throw badPath(path, at, isFlag ? "a flag of an arc, 0 or 1" : "a number");
        }
        at = next;
      }
      at = end(BLANKS, path, at);
    }
  }

  /** Where a match of {@code pattern} ends that begins at {@code from}; -1 if there is none. */
  private static int end(Pattern pattern, String text, int from) {
    Matcher matcher = pattern.matcher(text).region(from, text.length());
    return matcher.lookingAt() ? matcher.end() : -1;
  }

  private BadInput badPath(String path, int at, String expected) {
    String rest = path.substring(at, Math.min(at + 20, path.length()));
    return bad("path, character " + (at + 1) + ", at " + BadInput.quote(rest), expected);
  }

  private BadInput bad(String problem, String expected) {
    int line = xml.getLocation().getLineNumber();
    return new BadInput(file + ":" + line + ": " + problem + ": expected " + expected);
  }
}
