// SPDX-License-Identifier: MIT
#include "trace/glsl.h"

#include <algorithm>
#include <cmath>

#include "base/json.h"

namespace versorium {
namespace {

std::string name(int node) { return "v" + std::to_string(node); }

std::string binary(const Node& n, const char* op) { return name(n.a) + " " + op + " " + name(n.b); }
std::string call(const char* function, std::initializer_list<int> operands) {
    std::string text = std::string(function) + "(";
    for (int operand : operands) text += (text.back() == '(' ? "" : ", ") + name(operand);
    return text + ")";
}

std::string expression(const Node& n) {
    constexpr const char* kParts[] = {"x", "y", "z", "w"};
    switch (n.op) {
        case Op::constant:
            return glslFloat(n.constant);
        case Op::state:
            return "state[" + std::to_string(n.index) + "]";
        case Op::parameter:
            return "parameters[" + std::to_string(n.index) + "]";
        case Op::add:
            return binary(n, "+");
        case Op::subtract:
            return binary(n, "-");
        case Op::multiply:
            return binary(n, "*");
        case Op::divide:
            return binary(n, "/");
        case Op::negate:
            return "-" + name(n.a);
        case Op::squareRoot:
            return call("sqrt", {n.a});
        case Op::absolute:
            return call("abs", {n.a});
        case Op::minimum:
            return call("min", {n.a, n.b});
        case Op::maximum:
            return call("max", {n.a, n.b});
        case Op::floor:
            return call("floor", {n.a});
        case Op::exponential:
            return call("exp", {n.a});
        case Op::logarithm:
            return call("v_log", {n.a});
        case Op::sine:
            return call("v_sin", {n.a});
        case Op::cosine:
            return call("v_cos", {n.a});
        case Op::angle:
            return call("v_atan2", {n.a, n.b});
        case Op::power:
            return call("v_pow", {n.a, n.b});
        case Op::less:
            return binary(n, "<");
        case Op::lessEqual:
            return binary(n, "<=");
        case Op::equal:
            return binary(n, "==");
        case Op::notEqual:
            return binary(n, "!=");
        case Op::conjunction:
            return binary(n, "&&");
        case Op::disjunction:
            return binary(n, "||");
        case Op::negation:
            return "!" + name(n.a);
        case Op::select:
            return name(n.a) + " ? " + name(n.b) + " : " + name(n.c);
        case Op::complexPower:
            return "complexPower(vec2(" + name(n.a) + ", " + name(n.b) + "), " + name(n.e) + ")." +
                   kParts[n.index];
        case Op::quaternionPower:
            return "quaternionPower(vec4(" + name(n.a) + ", " + name(n.b) + ", " + name(n.c) +
                   ", " + name(n.d) + "), " + name(n.e) + ")." + kParts[n.index];
        case Op::distance:
            return "fieldAt(vec3(" + name(n.a) + ", " + name(n.b) + ", " + name(n.c) + "))";
        // Shaders are made for what is the same everywhere (gpu/gpu_orbits.cpp).
        case Op::alphaAt:
        case Op::betaAt:
            return name(n.d);
        default:
            return "";
    }
}

// Loop variables outlive their loop, so they are declared before it.
std::string loopVariables(const Tape& tape, std::size_t begin, const std::string& indent) {
    std::string text;
    for (std::size_t i = begin + 1; i < tape.nodes.size(); ++i) {
        const Node& node = tape.nodes[i];
        if (node.op == Op::loopEnd || node.op == Op::loopBegin) break;
        if (node.op == Op::loopVariable)
            text += indent + "float " + name(static_cast<int>(i)) + " = " + name(node.a) + ";\n";
    }
    return text;
}

std::string loopUpdates(const std::vector<Tape::Update>& updates, const std::string& indent) {
    std::string text;
    for (const Tape::Update& update : updates)
        text += indent + "float next" + std::to_string(update.variable) + " = " +
                name(update.next) + ";\n";
    for (const Tape::Update& update : updates)
        text +=
            indent + name(update.variable) + " = next" + std::to_string(update.variable) + ";\n";
    return text;
}

}  // namespace

std::string glslFloat(double value) {
    if (std::isnan(value)) return "uintBitsToFloat(0x7fc00000u)";
    if (std::abs(value) > 3.4e38)
        return value < 0 ? "uintBitsToFloat(0xff800000u)" : "uintBitsToFloat(0x7f800000u)";
    std::string text = formatNumber(value, 9);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return value < 0 ? "(" + text + ")" : text;
}

std::string glslStep(const Tape& tape) {
    const int parameters = std::max(tape.parameterSize, 1);
    std::string text = "void mapStep(inout float state[" + std::to_string(tape.stateSize) +
                       "], const float parameters[" + std::to_string(parameters) + "]) {\n";
    std::string indent = "    ";
    std::vector<int> lists;
    for (std::size_t i = 0; i < tape.nodes.size(); ++i) {
        const Node& node = tape.nodes[i];
        const std::string own = name(static_cast<int>(i));
        switch (node.op) {
            case Op::loopBegin: {
                text += loopVariables(tape, i, indent);
                const std::string counter = "i" + std::to_string(i);
                const std::string list = std::to_string(node.index);
                text += indent + "for (int " + counter + " = 0; " + counter + " < listSize(" +
                        list + "); ++" + counter + ") {\n";
                lists.push_back(static_cast<int>(i));
                indent += "    ";
                break;
            }
            case Op::loopVariable:
                break;
            case Op::listItem: {
                const Node& loop = tape.nodes[static_cast<std::size_t>(lists.back())];
                text += indent + "float " + own + " = listItem(" + std::to_string(loop.index) +
                        ", i" + std::to_string(lists.back()) + ", " + std::to_string(node.index) +
                        ");\n";
                break;
            }
            case Op::loopEnd:
                text += loopUpdates(tape.updates[static_cast<std::size_t>(node.index)], indent);
                indent.resize(indent.size() - 4);
                text += indent + "}\n";
                lists.pop_back();
                break;
            default:
                text += indent + (isTruth(node.op) ? "bool " : "float ") + own + " = " +
                        expression(node) + ";\n";
        }
    }
    for (std::size_t k = 0; k < tape.outputs.size(); ++k)
        text += indent + "state[" + std::to_string(k) + "] = " + name(tape.outputs[k]) + ";\n";
    return text + "}\n";
}

}  // namespace versorium
