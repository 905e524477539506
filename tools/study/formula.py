"""Arithmetic on parameters, for keys that follow from them: numbers, names, + - * / ** and a few functions."""

import ast
import math
import operator

_OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
              ast.Pow: operator.pow, ast.USub: operator.neg, ast.UAdd: operator.pos}
FUNCTIONS = {name: getattr(math, name) for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "radians", "degrees")}
FUNCTIONS |= {"min": min, "max": max, "abs": abs, "round": round}


class Formula:
    """`Formula(text).value({"speed": 0.5})`. Raises ValueError for text that is more than arithmetic."""

    def __init__(self, text):
        try:
            self._tree = ast.parse(text, mode="eval").body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            raise ValueError("is not arithmetic") from None
        self.names = set()
        self._look(self._tree)

    def _look(self, node):
        match node:
            case ast.Constant(value=int() | float()) if not isinstance(node.value, bool):
                pass
            case ast.Name(id=name):
                self.names.add(name)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
                self._look(left)
                self._look(right)
            case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
                self._look(operand)
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]) if name in FUNCTIONS:
                for argument in arguments:
                    self._look(argument)
            case _:
                raise ValueError(f"has `{ast.unparse(node)}`, which is not arithmetic (numbers, parameters, + - * / **, "
                                 f"{', '.join(FUNCTIONS)})")

    def value(self, numbers):
        """Raises ValueError when there is no finite value."""
        try:
            result = float(self._at(self._tree, numbers))
        except (ArithmeticError, ValueError, TypeError) as e:
            raise ValueError(f"has no value: {e}") from None
        if not math.isfinite(result):
            raise ValueError("has no finite value")
        return result

    def _at(self, node, numbers):
        match node:
            case ast.Constant(value=value):
                return float(value)
            case ast.Name(id=name):
                return numbers[name]
            case ast.BinOp(left=left, op=op, right=right):
                return _OPERATORS[type(op)](self._at(left, numbers), self._at(right, numbers))
            case ast.UnaryOp(op=op, operand=operand):
                return _OPERATORS[type(op)](self._at(operand, numbers))
            case ast.Call(func=ast.Name(id=name), args=arguments):
                return FUNCTIONS[name](*(self._at(argument, numbers) for argument in arguments))
