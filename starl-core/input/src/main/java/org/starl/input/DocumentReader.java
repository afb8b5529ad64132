package org.starl.input;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.dataformat.yaml.YAMLFactory;
import com.fasterxml.jackson.dataformat.yaml.YAMLParser;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Reads a document in YAML (or JSON, which YAML contains): one mapping, with the line of each part.
 * Refused are duplicate keys, aliases, more than one document, more than 16 levels, and more than 3
 * million characters, which the parser would refuse too. It reads Jackson's stream of tokens, for a phone has no
 * reflection on records, which data binding needs.
 */
public final class DocumentReader {

  private static final YAMLFactory YAML = new YAMLFactory();

  /** Twice as many as any document of StarL needs; it bounds the recursion below. */
  private static final int MAX_DEPTH = 16;

  private static final int MAX_CHARACTERS = 3_000_000;

  /** Of the tags that say of a value what it is already. */
  private static final String STANDARD_TAG = "tag:yaml.org,2002:";

  private final String file;
  private final String expected;
  private final YAMLParser parser;

  private DocumentReader(String file, String expected, YAMLParser parser) {
    this.file = file;
    this.expected = expected;
    this.parser = parser;
  }

  /**
   * The document in {@code text}.
   *
   * @param file its name, for messages
   * @param expected the end of messages: {@code expected lines such as 'a: b'}
   * @throws BadInput if it is no YAML, no mapping, or has anything that is refused
   */
  public static Node.Mapping read(String file, String text, String expected) {
    if (text.length() > MAX_CHARACTERS) {
      throw new BadInput(file + ": is longer than " + MAX_CHARACTERS + " characters; " + expected);
    }
    try (YAMLParser parser = YAML.createParser(text)) {
      return new DocumentReader(file, expected, parser).document();
    } catch (JsonProcessingException e) {
      throw FailureText.syntax(file, text, e, "YAML", expected);
    } catch (IOException e) {
      throw new IllegalStateException("reading a text from memory", e);
    }
  }

  private Node.Mapping document() throws IOException {
    JsonToken first = parser.nextToken();
    if (first != JsonToken.START_OBJECT) {
      throw BadInput.at(file, first == null ? 1 : line(), expected);
    }
    Node.Mapping mapping = mapping(line(), 1);
    if (parser.nextToken() != null) {
      throw wrong("expected one document");
    }
    return mapping;
  }

  private Node.Mapping mapping(int line, int depth) throws IOException {
    Map<String, Node> parts = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String key = parser.currentName();
      if (parser.currentToken() != JsonToken.FIELD_NAME || key == null) {
        throw wrong(expected);
      }
      if (parts.containsKey(key)) {
        throw wrong(key + ": expected this key once");
      }
      requireNoZero("", key);
      int keyLine = line();
      parts.put(key, value(parser.nextToken(), key, keyLine, depth));
    }
    return new Node.Mapping(line, parts);
  }

  /** The part that begins with {@code token}, which is the parser's last. */
  private Node value(@Nullable JsonToken token, String key, int line, int depth)
      throws IOException {
    if (depth == MAX_DEPTH) {
      throw wrong(key + ": expected at most " + MAX_DEPTH + " levels");
    }
    requireNoTag(key);
    if (token == JsonToken.START_OBJECT) {
      return mapping(line, depth + 1);
    }
    if (token == JsonToken.START_ARRAY) {
      List<Node> items = new ArrayList<>();
      while (parser.nextToken() != JsonToken.END_ARRAY) {
        items.add(value(parser.currentToken(), key, line(), depth + 1));
      }
      return new Node.Listing(line, items);
    }
    if (token == JsonToken.VALUE_NULL) {
      return new Node.Text(line, "");
    }
    if (parser.isCurrentAlias()) {
      throw wrong(
          key + ": '*" + parser.getText() + "': expected the value itself, without an alias");
    }
    // The parser gives no token for a number without digits, and bytes for base64.
    if (token == null || token == JsonToken.VALUE_EMBEDDED_OBJECT) {
      throw wrong(key + ": expected one value, a list or a mapping");
    }
    requireNoZero(key + ": ", parser.getText());
    return new Node.Text(line, parser.getText());
  }

  private void requireNoTag(String key) throws IOException {
    String tag = parser.getTypeId();
    if (tag != null && !tag.isEmpty() && !tag.startsWith(STANDARD_TAG)) {
      throw wrong(key + ": the tag '!" + tag + "': expected a value without it");
    }
  }

  /** An escape may stand for it; the system refuses it in names of files. */
  private void requireNoZero(String where, String text) {
    if (text.indexOf('\0') >= 0) {
      throw wrong(where + BadInput.quote(text) + ": expected a text without the character zero");
    }
  }

  /** An empty document has no token and so no line. */
  private int line() {
    return Math.max(1, parser.currentTokenLocation().getLineNr());
  }

  private BadInput wrong(String text) {
    return BadInput.at(file, line(), text);
  }
}
