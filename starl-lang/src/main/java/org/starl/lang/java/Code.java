package org.starl.lang.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** An expression of Java. */
sealed interface Code {

  /** Lays it out. */
  void write(Layout out);

  /** How strongly it binds; more is stronger. */
  default int strength() {
    return PRIMARY;
  }

  int PRIMARY = 20;
  int UNARY = 15;

  /** A name or literal. */
  record Text(String text) implements Code {
    static final Code TRUE = new Text("true");
    static final Code FALSE = new Text("false");

    @Override
    public void write(Layout out) {
      out.token(text);
    }
  }

  /** A name with its arguments, or without any. */
  record Item(String name, @Nullable List<Code> arguments) {
    boolean isCall() {
      return arguments != null;
    }
  }

  /** {@code new States(a, b)}. */
  record New(String type, List<Code> arguments) implements Code {
    @Override
    public void write(Layout out) {
      out.open(0).token("new ").token(type);
      Code.writeArguments(arguments, 4, out);
      out.close();
    }
  }

  /** {@code first.item.item(arguments)}. */
  record Chain(@Nullable Code first, List<Item> items) implements Code {
    @Override
    public void write(Layout out) {
      int prefix = first == null ? prefix() : -1;
      boolean isPrefixed = prefix >= 0;
      boolean goesOn = isPrefixed ? prefix < items.size() - 1 : length() > 1;
      if (length() == 1) {
        Item only = items.getFirst();
        out.token(only.name);
        Code.writeArguments(only.arguments, 4, out);
        return;
      }
      out.open(4);
      if (isPrefixed) {
        out.open(0);
      }
      int written = 0;
      Code head = first;
      if (head != null) {
        head.write(out);
        written = Code.width(head);
      }
      for (int i = 0; i < items.size(); i++) {
        Item item = items.get(i);
        if (i > 0 || first != null) {
          if (isPrefixed || written > 4) {
            out.brk("", isPrefixed && i <= prefix);
          }
          out.token(".");
          written++;
        }
        out.token(item.name);
        if (i == prefix) {
          out.close();
        }
        Code.writeArguments(item.arguments, goesOn ? 4 : 0, out);
        written += Code.width(new Chain(null, List.of(item)));
      }
      out.close();
    }

    private int length() {
      return items.size() + (first == null ? 0 : 1);
    }

    /** The last item that is not parted from the first: a type's member, or the only call. */
    private int prefix() {
      int i = 0;
      while (i < items.size() && items.get(i).name.chars().noneMatch(Character::isUpperCase)) {
        i++;
      }
      if (i < items.size() - 1
          && Character.isUpperCase(items.get(i).name.charAt(0))
          && items.get(i).name.chars().anyMatch(Character::isLowerCase)) {
        return i + 1;
      }
      long calls = items.stream().filter(Item::isCall).count();
      return calls == 1 && items.getLast().isCall() && items.size() > 1 ? items.size() - 1 : -1;
    }
  }

  /** Operands of one operator. */
  record Infix(String operator, List<Code> operands) implements Code {
    @Override
    public void write(Layout out) {
      boolean fills = Code.areShort(operands);
      out.open(4);
      for (int i = 0; i < operands.size(); i++) {
        if (i > 0) {
          out.brk(" ", fills).token(operator + " ");
        }
        operands.get(i).write(out);
      }
      out.close();
    }

    @Override
    public int strength() {
      return switch (operator) {
        case "||" -> 1;
        case "&&" -> 2;
        case "==", "!=" -> 3;
        case "<", "<=", ">", ">=" -> 4;
        case "+", "-" -> 5;
        default -> 6;
      };
    }
  }

  /**
   * A text with values in it: {@code "held(" + i + ") = " + held(i)}; with more than two a template:
   * {@code String.format("b = %s, c = %s, d = %s", b, c, d)}.
   *
   * @param parts literals and values; no literals are side by side
   */
  record Message(List<Code> parts) implements Code {
    private static final int MOST_JOINED = 2;

    @Override
    public void write(Layout out) {
      inJava().write(out);
    }

    @Override
    public int strength() {
      return inJava().strength();
    }

    private Code inJava() {
      List<Code> values = parts.stream().filter(part -> !isLiteral(part)).toList();
      if (values.size() <= MOST_JOINED) {
        return infix("+", parts.toArray(Code[]::new));
      }
      StringBuilder template = new StringBuilder();
      for (Code part : parts) {
        template.append(isLiteral(part) ? unquoted(part).replace("%", "%%") : "%s");
      }
      List<Code> arguments = new ArrayList<>(List.of(new Text("\"" + template + '"')));
      arguments.addAll(values);
      return call("String.format", arguments.toArray(Code[]::new));
    }

    private static boolean isTemplate(Code code) {
      return isLiteral(code) && unquoted(code).contains("%s");
    }

    private static boolean isLiteral(Code code) {
      return code instanceof Text literal && literal.text.startsWith("\"");
    }

    private static String unquoted(Code literal) {
      String text = ((Text) literal).text;
      return text.substring(1, text.length() - 1);
    }
  }

  /** {@code condition ? then : otherwise}. */
  record Choice(Code condition, Code then, Code otherwise) implements Code {
    @Override
    public void write(Layout out) {
      out.open(4);
      condition.write(out);
      out.brk(" ").token("? ");
      then.write(out);
      out.brk(" ").token(": ");
      otherwise.write(out);
      out.close();
    }

    @Override
    public int strength() {
      return 0;
    }
  }

  /** {@code x -> body}, {@code () -> body}. */
  record Lambda(String parameters, Code body) implements Code {
    @Override
    public void write(Layout out) {
      out.token(parameters + " ->").open(4).brk(" ");
      body.write(out);
      out.close();
    }

    @Override
    public int strength() {
      return 0;
    }
  }

  /** {@code !x}, {@code -x}, {@code (Type) x}. */
  record Prefix(String prefix, Code of) implements Code {
    @Override
    public void write(Layout out) {
      out.token(prefix);
      of.write(out);
    }

    @Override
    public int strength() {
      return UNARY;
    }
  }

  /** {@code x instanceof Type}. */
  record InstanceOf(Code of, String pattern) implements Code {
    @Override
    public void write(Layout out) {
      out.open(4);
      of.write(out);
      out.brk(" ").open(0).token("instanceof").brk(" ").token(pattern).close().close();
    }

    @Override
    public int strength() {
      return 4;
    }
  }

  /** {@code (x)}. */
  record Parentheses(Code of) implements Code {
    @Override
    public void write(Layout out) {
      out.token("(");
      of.write(out);
      out.token(")");
    }
  }

  /** The length of its text on one line. */
  static int width(Code code) {
    Layout out = new Layout();
    code.write(out);
    return out.width();
  }

  static boolean areShort(List<Code> codes) {
    return codes.stream().allMatch(code -> width(code) < 10);
  }

  static void writeArguments(@Nullable List<Code> arguments, int indent, Layout out) {
    if (arguments == null) {
      return;
    }
    out.open(indent).token("(");
    if (!arguments.isEmpty()) {
      out.brk("").open(0);
      if (Message.isTemplate(arguments.getFirst())) {
        arguments.getFirst().write(out);
        out.token(",").brk(" ").open(0);
        writeList(arguments.subList(1, arguments.size()), out);
        out.close();
      } else {
        writeList(arguments, out);
      }
      out.close();
    }
    out.token(")").close();
  }

  private static void writeList(List<Code> arguments, Layout out) {
    boolean fills = areShort(arguments);
    for (int i = 0; i < arguments.size(); i++) {
      if (i > 0) {
        out.token(",").brk(" ", fills);
      }
      arguments.get(i).write(out);
    }
  }

  static Code name(String name) {
    return new Text(name);
  }

  /** {@code "text"}. */
  static Code string(String text) {
    return new Text('"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"');
  }

  /** {@code a}, then {@code b}, in one text. */
  static Code message(Code a, Code b) {
    List<Code> parts = new ArrayList<>(a instanceof Message begun ? begun.parts : List.of(a));
    for (Code part : b instanceof Message more ? more.parts : List.of(b)) {
      if (Message.isLiteral(parts.getLast()) && Message.isLiteral(part)) {
        String text = Message.unquoted(parts.removeLast()) + Message.unquoted(part);
        parts.add(new Text('"' + text + '"'));
      } else {
        parts.add(part);
      }
    }
    return parts.size() == 1 ? parts.getFirst() : new Message(List.copyOf(parts));
  }

  /** {@code Type.function(arguments)}, {@code function(arguments)}. */
  static Code call(String function, Code... arguments) {
    List<Item> items = new ArrayList<>();
    String[] names = function.split("\\.", -1);
    for (int i = 0; i < names.length; i++) {
      items.add(new Item(names[i], i < names.length - 1 ? null : List.of(arguments)));
    }
    return new Chain(null, List.copyOf(items));
  }

  /** {@code this.method(arguments)}. */
  default Code then(String method, Code... arguments) {
    return with(new Item(method, List.of(arguments)));
  }

  /** {@code this.field}. */
  default Code field(String field) {
    return with(new Item(field, null));
  }

  private Code with(Item item) {
    List<Item> items = new ArrayList<>();
    Code head = null;
    switch (this) {
      case Chain chain -> {
        head = chain.first;
        items.addAll(chain.items);
      }
      case Text text when !text.text.isEmpty() && Character.isLetter(text.text.charAt(0)) ->
          items.add(new Item(text.text, null));
      default -> head = strong(this, PRIMARY);
    }
    items.add(item);
    return new Chain(head, List.copyOf(items));
  }

  /** {@code code}, in parentheses if it binds less than {@code strength}. */
  static Code strong(Code code, int strength) {
    return code.strength() < strength ? new Parentheses(code) : code;
  }

  /** Operands of one operator that may stand in any grouping: {@code &&}, {@code ||}, {@code +}. */
  static Code infix(String operator, Code... parts) {
    int strength = new Infix(operator, List.of()).strength();
    List<Code> operands = new ArrayList<>();
    for (int i = 0; i < parts.length; i++) {
      Code part = parts[i];
      boolean isSame = part instanceof Infix same && same.operator.equals(operator);
      if (isSame && (i == 0 || Set.of("&&", "||").contains(operator))) {
        operands.addAll(((Infix) part).operands);
      } else if (isLogic(operator) && part instanceof Infix other && isLogic(other.operator)) {
        operands.add(new Parentheses(part));
      } else {
        operands.add(strong(part, strength + 1));
      }
    }
    return new Infix(operator, List.copyOf(operands));
  }

  private static boolean isLogic(String operator) {
    return operator.equals("&&") || operator.equals("||");
  }

  static Code and(Code a, Code b) {
    if (a.equals(Text.FALSE) || b.equals(Text.FALSE)) {
      return Text.FALSE;
    }
    return a.equals(Text.TRUE) ? b : b.equals(Text.TRUE) ? a : infix("&&", a, b);
  }

  static Code or(Code a, Code b) {
    if (a.equals(Text.TRUE) || b.equals(Text.TRUE)) {
      return Text.TRUE;
    }
    return a.equals(Text.FALSE) ? b : b.equals(Text.FALSE) ? a : infix("||", a, b);
  }

  static Code not(Code a) {
    if (a.equals(Text.TRUE) || a.equals(Text.FALSE)) {
      return a.equals(Text.TRUE) ? Text.FALSE : Text.TRUE;
    }
    if (a instanceof Prefix no && no.prefix.equals("!")) {
      return no.of instanceof Parentheses inner ? inner.of : no.of;
    }
    if (a instanceof Infix same && same.operands.size() == 2) {
      String opposite =
          switch (same.operator) {
            case "==" -> "!=";
            case "!=" -> "==";
            default -> "";
          };
      if (!opposite.isEmpty()) {
        return new Infix(opposite, same.operands);
      }
    }
    return new Prefix("!", strong(a, UNARY));
  }

  static Code choice(Code condition, Code then, Code otherwise) {
    if (condition.equals(Text.TRUE) || then.equals(otherwise)) {
      return then;
    }
    return condition.equals(Text.FALSE)
        ? otherwise
        : new Choice(strong(condition, 1), strong(then, 1), otherwise);
  }
}
