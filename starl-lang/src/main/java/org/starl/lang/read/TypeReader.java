package org.starl.lang.read;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.BinderGroupContext;
import org.starl.lang.grammar.StarlParser.IdContext;
import org.starl.lang.grammar.StarlParser.TypeContext;
import org.starl.lang.tree.Type;
import org.starl.lang.tree.Type.Constructor;
import org.starl.lang.tree.Type.Field;

/** Reads types, and declarations of types. */
final class TypeReader {

  private final Scope scope;
  private final Problems problems;

  TypeReader(Scope scope, Problems problems) {
    this.scope = scope;
    this.problems = problems;
  }

  Type type(TypeContext at) {
    return switch (at) {
      case StarlParser.SetTypeContext set -> new Type.SetOf(type(set.type()));
      case StarlParser.ListTypeContext list -> new Type.ListOf(type(list.type()));
      case StarlParser.OptionTypeContext option -> new Type.OptionOf(type(option.type()));
      case StarlParser.MapTypeContext map -> {
        List<Type> all = new ArrayList<>();
        map.type().forEach(each -> all.add(type(each)));
        yield new Type.MapOf(List.copyOf(all.subList(0, all.size() - 1)), all.getLast());
      }
      case StarlParser.NamedTypeContext named -> named(named.name);
      default -> throw new IllegalStateException("type " + at.getText());
    };
  }

  private Type named(IdContext at) {
    Type known = scope.types.get(at.getText());
    if (known == null) {
      String near = Language.nearest(at.getText(), List.copyOf(scope.types.keySet()));
      problems.add(
          at,
          "'"
              + at.getText()
              + "' is no type; expected one of "
              + String.join(", ", scope.types.keySet())
              + (near.isEmpty() ? "" : "; is it " + near + "?"));
      throw new Wrong();
    }
    return known;
  }

  /** The fields of {@code i, j: PIDS, z: Zones}; a name twice is told. */
  List<Field> fields(List<BinderGroupContext> groups, boolean mayShadow) {
    List<Field> fields = new ArrayList<>();
    Set<String> names = new TreeSet<>();
    for (BinderGroupContext group : groups) {
      Type type = type(group.type());
      for (IdContext id : group.id()) {
        String name = id.getText();
        Optional<String> taken = mayShadow ? Optional.empty() : scope.taken(name);
        if (!names.add(name)) {
          problems.add(id, "'" + name + "' is here twice; expected different names");
        } else if (taken.isPresent()) {
          problems.add(id, "'" + name + "' is " + taken.get() + " already; expected a new name");
        }
        fields.add(new Field(name, type));
      }
    }
    return List.copyOf(fields);
  }

  /** Declares a type. */
  Type declare(StarlParser.TypePartContext at) {
    String name = at.name.getText();
    scope
        .taken(name)
        .ifPresent(what ->
            problems.add(at.name, "'" + name + "' is " + what + " already; expected a new name"));
    Type type =
        switch (at.typeBody()) {
          case StarlParser.RecordBodyContext body ->
              new Type.Rec(scope.automaton, name, fields(body.binderGroup(), true));
          case StarlParser.SumBodyContext body -> sum(name, body);
          case StarlParser.AliasBodyContext body -> new Type.Alias(name, type(body.type()));
          default -> throw new IllegalStateException("type " + at.getText());
        };
    scope.types.put(name, type);
    return type;
  }

  private Type.Sum sum(String name, StarlParser.SumBodyContext body) {
    List<Constructor> constructors = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (StarlParser.ConstructorContext each : body.constructor()) {
      String constructor = each.name.getText();
      Optional<String> taken = scope.taken(constructor);
      if (taken.isPresent() || !names.add(constructor)) {
        problems.add(
            each.name,
            "'"
                + constructor
                + "' is "
                + taken.orElse("a value of " + name)
                + " already; expected a new name");
      }
      constructors.add(new Constructor(constructor, fields(each.binderGroup(), true)));
    }
    Type.Sum sum = new Type.Sum(scope.automaton, name, List.copyOf(constructors));
    constructors.forEach(c -> scope.constructors.put(c.name(), new Scope.Known(sum, c)));
    return sum;
  }
}
