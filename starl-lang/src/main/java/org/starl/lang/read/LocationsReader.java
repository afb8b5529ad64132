package org.starl.lang.read;

import static org.starl.lang.read.Problems.pos;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.antlr.v4.runtime.ParserRuleContext;
import org.starl.lang.grammar.StarlParser;
import org.starl.lang.grammar.StarlParser.BranchContext;
import org.starl.lang.grammar.StarlParser.LocationPartContext;
import org.starl.lang.grammar.StarlParser.StatementContext;
import org.starl.lang.tree.Expr;
import org.starl.lang.tree.Exprs;
import org.starl.lang.tree.Primitive;
import org.starl.lang.tree.Program.Branch;
import org.starl.lang.tree.Program.Instance;
import org.starl.lang.tree.Program.Location;
import org.starl.lang.tree.Program.Statement;
import org.starl.lang.tree.Type;

/** Reads the locations of a program, whose other names are known. */
final class LocationsReader {

  private final ProgramReader program;
  private final Scope scope;
  private final Problems problems;
  private final ExpressionReader expressions;
  private final Map<String, Instance> instances;
  private final Map<String, LocationPartContext> parts = new LinkedHashMap<>();
  private final Set<String> entered = new LinkedHashSet<>();

  LocationsReader(ProgramReader program, Map<String, Instance> instances) {
    this.program = program;
    this.instances = instances;
    scope = program.scope;
    problems = program.problems;
    expressions = program.expressions;
  }

  List<Location> read(List<LocationPartContext> all) {
    for (LocationPartContext at : all) {
      if (parts.putIfAbsent(program.freshName(at.name), at) != null) {
        problems.add(at.name, "location '" + at.name.getText() + "' is here twice; expected once");
      }
    }
    List<Location> locations = new ArrayList<>();
    all.forEach(at -> locations.add(location(at)));
    if (all.isEmpty()) {
      problems.add(
          program.whole,
          "program '" + scope.automaton + "' has no location; expected 'location' and its name");
    } else {
      entered.add(all.getFirst().name.getText());
      parts.forEach((name, at) -> {
        if (!entered.contains(name) && problems.isEmpty()) {
          problems.add(
              at.name,
              "no branch leads to location '" + name + "'; expected 'goto " + name + "' somewhere");
        }
      });
    }
    return List.copyOf(locations);
  }

  private Location location(LocationPartContext at) {
    List<Branch> branches = new ArrayList<>();
    boolean isAlways = false;
    for (BranchContext branch : at.branch()) {
      if (isAlways) {
        problems.add(
            branch,
            "this branch is never taken: the one before it has no 'when'; expected it last");
      }
      isAlways = branch.WHEN() == null;
      program.orTold(() -> branches.add(new BranchReader(branch).read()));
    }
    return new Location(
        at.name.getText(), List.copyOf(branches), program.source.before(at), pos(at));
  }

  /** Reads one branch. */
  private final class BranchReader {

    private final BranchContext branch;
    private final Set<String> stepped = new LinkedHashSet<>();
    private final List<Statement> statements = new ArrayList<>();

    private BranchReader(BranchContext branch) {
      this.branch = branch;
    }

    private Branch read() {
      Expr guard = new Expr.Bool(true, pos(branch));
      if (branch.WHEN() != null) {
        guard = expressions.bool(branch.expression());
        outcome(guard).ifPresent(stepped::add);
      }
      List<StatementContext> all = branch.statement();
      all.subList(0, all.size() - 1)
          .forEach(each -> program.orTold(() -> statements.add(statement(each))));
      StatementContext last = all.getLast();
      String to = target(last);
      return new Branch(
          guard,
          branch.WHEN() == null ? "" : SourceText.of(branch.expression()),
          List.copyOf(statements),
          to,
          pos(last),
          pos(branch));
    }

    /** The instance of whose outcomes one is a conjunct; elsewhere none may be. */
    private Optional<String> outcome(Expr guard) {
      List<String> found = new ArrayList<>();
      for (Expr conjunct : Guards.conjuncts(guard)) {
        Optional<String> instance =
            Guards.outcome(conjunct, instances).map(Guards.Happened::instance);
        instance.ifPresent(found::add);
        if (instance.isEmpty()) {
          check(conjunct, branch.expression());
        }
      }
      if (found.size() > 1) {
        throw expressions.wrong(
            branch.expression(),
            "'"
                + SourceText.of(branch.expression())
                + "' asks for two outcomes; expected one, and a branch for the other");
      }
      return found.stream().findFirst();
    }

    /** An outcome is a conjunct of a guard; an instance is there for its values; these may be stale. */
    private void check(Expr expr, ParserRuleContext at) {
      Optional<Guards.Happened> found = Guards.outcome(expr, instances);
      if (found.isPresent()) {
        String name = found.get().instance() + "." + found.get().outcome().name();
        throw expressions.wrong(
            at,
            "'"
                + name
                + "' stands inside another expression; expected it as a guard, or as a part of one: 'when "
                + name
                + " and ...'");
      }
      if (expr instanceof Expr.Get get && get.of() instanceof Expr.Component component) {
        if (stepped.contains(component.name())) {
          throw expressions.wrong(
              at,
              "'"
                  + SourceText.of(at)
                  + "' reads '"
                  + component.name()
                  + "' after its step; expected it before, or at the next location");
        }
      } else if (expr instanceof Expr.Component component
          && instances.containsKey(component.name())) {
        throw expressions.wrong(
            at,
            "'" + component.name() + "' is no value; expected one of what it tells, after a dot");
      } else {
        Exprs.parts(expr).forEach(part -> check(part, at));
      }
    }

    private String target(StatementContext last) {
      if (last instanceof StarlParser.RestartContext) {
        return "";
      }
      if (!(last instanceof StarlParser.GotoContext at)) {
        throw expressions.wrong(
            last,
            "the branch ends with '"
                + SourceText.of(last)
                + "'; expected 'goto' and a location after it, or 'restart'");
      }
      String name = at.to.getText();
      LocationPartContext location = parts.get(name);
      if (location == null) {
        throw expressions.wrong(
            at.to, "'" + name + "' is no location; " + oneOf(name, parts.keySet()));
      }
      entered.add(name);
      problems.refer(at.to, "location " + name, pos(location.name));
      return name;
    }

    private Statement statement(StatementContext at) {
      return switch (at) {
        case StarlParser.CallContext call -> call(call);
        case StarlParser.AssignContext assign -> assign(assign);
        default ->
            throw expressions.wrong(
                at, "'" + SourceText.of(at) + "' is not the last statement; expected it there");
      };
    }

    private Statement assign(StarlParser.AssignContext at) {
      String name = at.name.getText();
      Type type = scope.state.get(name);
      if (scope.wrong.contains(name)) {
        throw new Wrong();
      }
      if (type == null || instances.containsKey(name)) {
        List<String> known =
            scope.state.keySet().stream().filter(each -> !instances.containsKey(each)).toList();
        throw expressions.wrong(at.name, "'" + name + "' is no variable; " + oneOf(name, known));
      }
      problems.refer(at.name, name + ": " + type, scope.place(name, at.name));
      return new Statement.Assign(name, read(at.expression(), type), SourceText.of(at), pos(at));
    }

    private Statement call(StarlParser.CallContext at) {
      String name = at.used.getText();
      Instance instance = instances.get(name);
      if (instance == null) {
        if (scope.wrong.contains(name)) {
          throw new Wrong();
        }
        throw expressions.wrong(
            at.used, "'" + name + "' is no primitive here; " + oneOf(name, instances.keySet()));
      }
      List<Primitive.Call> calls = instance.primitive().calls();
      String wanted = at.name.getText();
      Primitive.Call call =
          instance
              .primitive()
              .call(wanted)
              .orElseThrow(() ->
                  expressions.wrong(
                      at.name,
                      "'%s' is no call of %s; %s"
                          .formatted(
                              wanted,
                              instance.primitive().name(),
                              oneOf(wanted, calls.stream().map(Primitive.Call::name).toList()))));
      problems.refer(at.used, name + ": " + instance.primitive().name(), instance.pos());
      problems.refer(
          at.name, wanted + "(" + TypeReader.list(call.parameters()) + ")", instance.pos());
      List<Expr> arguments = expressions.arguments(wanted, call.parameters(), at.expression(), at);
      for (int i = 0; i < arguments.size(); i++) {
        check(arguments.get(i), at.expression(i));
      }
      if (!stepped.add(name)) {
        throw expressions.wrong(
            at,
            "'"
                + name
                + "' takes two steps in this branch; expected one, and a further location for the other");
      }
      return new Statement.Call(name, call, arguments, SourceText.of(at), pos(at));
    }

    private Expr read(StarlParser.ExpressionContext at, Type type) {
      Expr value = expressions.read(at, type);
      check(value, at);
      return value;
    }

    private static String oneOf(String name, java.util.Collection<String> known) {
      return known.isEmpty() ? "expected a declaration of it before" : Problems.oneOf(name, known);
    }
  }
}
