package org.starl.apps.lightpaint.view;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.apache.batik.anim.dom.SAXSVGDocumentFactory;
import org.apache.batik.anim.dom.SVGOMDocument;
import org.apache.batik.css.engine.CSSEngine;
import org.apache.batik.css.engine.CSSStylableElement;
import org.apache.batik.css.engine.sac.CSSConditionFactory;
import org.apache.batik.css.parser.DefaultDocumentHandler;
import org.apache.batik.css.parser.Parser;
import org.apache.batik.util.SVGConstants;
import org.starl.input.BadInput;
import org.w3c.css.sac.CSSException;
import org.w3c.css.sac.CSSParseException;
import org.w3c.css.sac.InputSource;
import org.w3c.dom.Attr;
import org.w3c.dom.DOMException;
import org.w3c.dom.Element;
import org.w3c.dom.NamedNodeMap;
import org.w3c.dom.NodeList;
import org.xml.sax.Attributes;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;

/**
 * Reads an SVG file for Batik, with the line of each element. What browsers know and Batik does not
 * is put into its words, or noted, or refused.
 */
final class SvgFile extends SAXSVGDocumentFactory {

  private static final int MAX_ELEMENTS = 20_000;

  /** The JDK reads 100, in its own words. */
  private static final int MAX_DEPTH = 90;

  /** Elements that a browser shows, without a stroke. */
  private static final Set<String> NOT_LINES =
      Set.of(
          "image",
          "foreignObject",
          "script",
          "set",
          "animate",
          "animateColor",
          "animateMotion",
          "animateTransform");

  private static final Pattern DECLARATION =
      Pattern.compile("([-\\w]++)\\s*+:\\s*+([^;:{}]++)(?=[;}]|$)");

  /** Properties that decide whether and how a line is painted; a browser ignores wrong others, too. */
  private static final List<String> PAINTED =
      List.of("stroke", "fill", "color", "stroke-width", "display", "visibility");

  /** Attributes that are also properties since SVG 2. */
  private static final Pattern GEOMETRY =
      Pattern.compile("x|y|width|height|cx|cy|r|rx|ry|d|transform(-origin)?|vector-effect");

  /** Properties of one browser, and those that only {@code var()} reads. */
  private static final Pattern OWN_PROPERTY =
      Pattern.compile("(?<![\\w-])-[-\\w]++\\s*+:[^;}]*+;?+");

  private static final Pattern COLOUR =
      Pattern.compile(
          "rgba?\\(\\s*([\\d.]+%?)[\\s,]+([\\d.]+%?)[\\s,]+([\\d.]+%?)(?:[\\s,/]+([\\d.]+)%?)?\\s*\\)"
              + "|(?<=:)\\s*#(\\p{XDigit}{6})(\\p{XDigit}{2})\\b"
              + "|(?<=:)\\s*#(\\p{XDigit}{3})(\\p{XDigit})\\b|\\b(transparent)\\b");

  private static final String TWICE =
      "(?s)Attribute \"([^\"]*)\" (?:bound .* )?was already specified.*";

  private final String file;
  private final byte[] bytes;
  private final SVGOMDocument drawing;
  private final Map<String, int[]> notes = new TreeMap<>();
  private int elements;
  private int depth;
  private boolean isChecked;

  /** The element that is being drawn. */
  Element built;

  /**
   * @throws BadInput if the file is no SVG drawing
   */
  SvgFile(String file, byte[] bytes) {
    super(null, true);
    this.file = file;
    this.bytes = bytes;
    try {
      drawing = (SVGOMDocument) createSVGDocument("file:/", new ByteArrayInputStream(bytes));
    } catch (IOException e) { // Its encoding is unknown, or another.
      throw bad(1, BadInput.quote(textLine(1)) + " is not text in its encoding", "an SVG drawing");
    }
    built = drawing.getDocumentElement();
    all().forEach(SvgFile::translate);
  }

  SVGOMDocument drawing() {
    return drawing;
  }

  private List<Element> all() {
    NodeList all = drawing.getElementsByTagNameNS("*", "*");
    return IntStream.range(0, all.getLength()).mapToObj(i -> (Element) all.item(i)).toList();
  }

  /** What is not painted as a browser does: a line for each kind. */
  List<String> notes() {
    List<String> lines = new ArrayList<>();
    notes.forEach((text, at) ->
        lines.add(file + ":" + at[0] + ": " + text + (at[1] > 1 ? ", " + at[1] + " times" : "")));
    return lines;
  }

  void note(int line, String text) {
    notes.computeIfAbsent(text, key -> new int[] {line, 0})[1]++;
  }

  /** The line of an element's start tag, or for a copy, of the element that copies it. */
  int line(Element element) {
    int line = documentDescriptor.getLocationLine(element);
    Element parent = CSSEngine.getParentCSSStylableElement(element);
    return line > 0 || parent == null ? Math.max(1, line) : line(parent);
  }

  BadInput bad(int line, String problem, String expected) {
    return BadInput.at(file, line, problem + ": expected " + expected);
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes)
      throws SAXException {
    int line = locator.getLineNumber();
    boolean isSvg = SVGConstants.SVG_NAMESPACE_URI.equals(uri);
    if (document == null && !(isSvg && local.equals("svg"))) {
      String root = "<svg xmlns=\"" + SVGConstants.SVG_NAMESPACE_URI + "\">, of an SVG drawing";
      throw bad(line, "<" + name + ">", root);
    }
    depth++;
    count(line);
    boolean isShown = !(isSvg && NOT_LINES.contains(local));
    try {
      super.startElement(uri, local, isShown ? name : "desc", attributes);
    } catch (DOMException e) { // No element of SVG 1.1.
      isShown = false;
      super.startElement(uri, local, "desc", attributes);
    }
    if (!isShown) {
      note(line, "<" + local + "> is not painted");
    } else if (local.equals("link") && "stylesheet".equals(attributes.getValue("rel"))) {
      noteSheet();
    }
  }

  @Override
  public void processingInstruction(String target, String data) {
    if (target.equals("xml-stylesheet")) {
      noteSheet();
    }
  }

  private void noteSheet() {
    note(locator.getLineNumber(), "a style sheet outside of the file is not applied");
  }

  @Override
  public void endElement(String uri, String local, String name) throws SAXException {
    depth--;
    super.endElement(uri, local, name);
  }

  /** Counts a copy that {@code use} makes. */
  void countCopy(Element use) {
    String link = use.getAttributeNS(SVGConstants.XLINK_NAMESPACE_URI, "href");
    depth = 0;
    for (Element at = use; at != null; at = CSSEngine.getParentCSSStylableElement(at)) {
      depth++;
      boolean isSame =
          at.getLocalName().equals("use")
              && at.getAttributeNS(SVGConstants.XLINK_NAMESPACE_URI, "href").equals(link);
      if (isSame && at != use) {
        String what = "<use> refers to " + BadInput.quote(link) + ", which holds it";
        throw bad(line(use), what, "no link in a ring");
      }
    }
    count(line(use));
  }

  private void count(int line) {
    if (++elements > MAX_ELEMENTS || depth > MAX_DEPTH) {
      String most = "at most %d, %d deep".formatted(MAX_ELEMENTS, MAX_DEPTH);
      throw bad(line, elements + " elements, " + depth + " deep", most);
    }
  }

  @Override
  public void skippedEntity(String name) {
    throw bad(locator.getLineNumber(), "&" + name + ";", "an entity whose text is in the file");
  }

  @Override
  public void fatalError(SAXParseException error) {
    int number = Math.max(1, error.getLineNumber());
    int at = Math.max(1, error.getColumnNumber());
    String line = textLine(number);
    int to = Math.min(line.length(), at - 1);
    String before = BadInput.quote(line.substring(Math.max(0, to - 40), to));
    String twice =
        String.valueOf(error.getMessage()).replaceFirst(TWICE, "attribute $1 is there twice");
    if (!twice.equals(error.getMessage())) {
      throw bad(number, twice, "it once");
    }
    if (String.valueOf(error.getMessage()).startsWith("JAXP")) {
      String most = "at most 2500 entities of 100000 characters, and 200 attributes";
      throw bad(number, "has more than is read, after " + before, most);
    }
    throw bad(number, "is not XML at character " + at + ", after " + before, "an SVG drawing");
  }

  private String textLine(int number) {
    String text = new String(bytes, StandardCharsets.UTF_8);
    return text.lines().skip(number - 1).findFirst().orElse("");
  }

  /** The start tag of an element. */
  static String tag(Element element) {
    StringBuilder tag = new StringBuilder("<" + element.getLocalName());
    NamedNodeMap all = element.getAttributes();
    for (int i = 0; i < all.getLength(); i++) {
      if (((Attr) all.item(i)).getSpecified()) {
        tag.append(' ').append(all.item(i).getNodeName()).append('=');
        tag.append(BadInput.quote(all.item(i).getNodeValue()));
      }
    }
    return tag.append('>').toString();
  }

  /** Puts what Batik does not know into its words. */
  private static void translate(Element element) {
    for (String name : List.of("style", "fill", "stroke", "color")) {
      if (element.hasAttribute(name)) {
        element.setAttribute(name, translated(":" + element.getAttribute(name)).substring(1));
      }
    }
    for (MatchResult own : DECLARATION.matcher(element.getAttribute("style")).results().toList()) {
      if (GEOMETRY.matcher(own.group(1)).matches()) {
        element.setAttribute(own.group(1), own.group(2).replaceAll("(?<=[0-9])(px|deg)\\b", ""));
      }
    }
    if (element.hasAttribute("href")) {
      String href = element.getAttribute("href");
      element.setAttributeNS(SVGConstants.XLINK_NAMESPACE_URI, "xlink:href", href);
    }
    if (isSheet(element)) {
      element.setTextContent(translated(element.getTextContent()));
    }
  }

  private static String translated(String style) {
    String plain = OWN_PROPERTY.matcher(style).replaceAll("");
    return COLOUR
        .matcher(plain)
        .replaceAll(SvgFile::colour)
        .replaceAll(
            "light-dark\\(([^,()]*(?:\\([^()]*\\))?)\\s*,[^()]*(?:\\([^()]*\\))?\\s*\\)", "$1");
  }

  /** A colour with its transparency as one without; {@code none} if it cannot be seen. */
  private static String colour(MatchResult match) {
    String alpha = match.group(4) + match.group(6) + match.group(8);
    boolean isClear = alpha.matches("(null|[0.])+") && !alpha.equals("nullnullnull");
    if (isClear || match.group(9) != null) {
      return "none";
    }
    String rgb = "rgb(" + match.group(1) + "," + match.group(2) + "," + match.group(3) + ")";
    String hex = match.group(5) == null ? match.group(7) : match.group(5);
    return hex == null ? rgb.replaceAll("\\.[0-9]*", "") : "#" + hex;
  }

  private static boolean isSheet(Element element) {
    return "style".equals(element.getLocalName());
  }

  /** Refuses styles that Batik would skip, or would refuse without the line. */
  void checkStyles() {
    CSSEngine engine = drawing.getCSSEngine();
    for (Element element : all()) {
      int first = line(element);
      if (element.hasAttribute("transform-origin")) {
        throw bad(first, tag(element), "the origin as a translate(...) in its transform");
      }
      boolean isSheet = isSheet(element);
      String style = isSheet ? element.getTextContent() : element.getAttribute("style");
      checkGrammar(first, style, isSheet);
      for (MatchResult own : DECLARATION.matcher(style).results().toList()) {
        int line =
            first + (int) style.substring(0, own.start()).chars().filter(c -> c == '\n').count();
        String name = own.group(1);
        if (isSheet && GEOMETRY.matcher(name).matches()) {
          throw bad(line, name + " in a style sheet", "it as an attribute");
        }
        check(element, engine, line, name, own.group(2).replaceFirst("!\\s*important\\s*$", ""));
      }
      for (String name : PAINTED) {
        check(element, engine, first, name, element.getAttribute(name));
      }
    }
    isChecked = true;
  }

  /** Whether an error of Batik's is of no style in the file. */
  boolean isChecked() {
    return isChecked;
  }

  private void check(Element element, CSSEngine engine, int line, String name, String value) {
    boolean isSet = PAINTED.contains(name) && !value.isEmpty();
    if (isSet && element instanceof CSSStylableElement styled) {
      try {
        engine.parsePropertyValue(styled, name, value);
      } catch (DOMException | CSSException e) {
        throw bad(line, name + "=" + BadInput.quote(value), expected(name));
      }
    }
  }

  private void checkGrammar(int first, String style, boolean isSheet) {
    Parser parser =
        new Parser() {
          @Override
          protected void reportError(CSSParseException error) {
            throw error;
          }
        };
    parser.setConditionFactory(new CSSConditionFactory(null, "class", null, "id"));
    parser.setDocumentHandler(DefaultDocumentHandler.INSTANCE);
    try {
      if (isSheet) {
        parser.parseStyleSheet(new InputSource(new StringReader(style)));
      } else {
        parser.parseStyleDeclaration(style);
      }
    } catch (IOException | CSSException e) {
      int line = e instanceof CSSParseException at ? Math.max(0, at.getLineNumber() - 1) : 0;
      String text = style.lines().skip(line).findFirst().orElse("").strip();
      throw bad(first + line, "style " + BadInput.quote(text), "style rules of CSS 2");
    }
  }

  /** The form of an attribute's value, for messages. */
  static String expected(String attribute) {
    return switch (attribute) {
      case "d" -> "a path such as M 0 0 L 10 5";
      case "points" -> "numbers in pairs, such as 0,0 10,5";
      case "viewBox" -> "four numbers, the last two above 0";
      case "transform" -> "transforms such as translate(10,20) rotate(45)";
      case "xlink:href" -> "a link to an element of the drawing, such as #a";
      case "fill", "stroke", "color" -> "a colour such as #ff8000, rgb(255,128,0) or red";
      default -> "a value of SVG 1.1, such as 12.5 or 3mm for a length";
    };
  }
}
