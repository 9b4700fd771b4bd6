"""Rows as text."""

from verdict import Ratio, mean_error, ratios


def rows_table(rows: list[dict]) -> str:
    """Every row with its seconds, its Q or error, and its memory."""
    head = [
        "case",
        "program",
        "method",
        "passes",
        "threads",
        "seconds",
        "assembly s",
        "Q",
        "error vox",
        "MB",
    ]
    return aligned(head, [row_cells(row) for row in rows])


def row_cells(row: dict) -> list[str]:
    return [
        row["case"],
        f"{row['peer']} {row['version']}",
        row["method"],
        str(row.get("iterations", "")),
        str(row["threads"]),
        f"{row['seconds']:.3f}",
        f"{row['assembly_seconds']:.2f}",
        f"{row['q']:.3f}" if "q" in row else "",
        error_text(row) if "vectors" in row else "",
        f"{row['peak_mb']:.0f}" if "peak_mb" in row else "",
    ]


def error_text(row: dict) -> str:
    return " ".join(f"{error:.4f}" for error in row["mean_abs_error_vox"])


def ratios_table(rows: list[dict]) -> str:
    """How often faster this program is than each peer; the bar is for equal threads."""
    head = ["case", "peer", "lfpiv", "threads", "faster", "by CPU", "needed", "Q or error", "bar"]
    return aligned(head, [ratio_cells(ratio) for ratio in ratios(rows)])


def ratio_cells(ratio: Ratio) -> list[str]:
    own, peer = ratio.own, ratio.peer
    reached = (
        f"Q {own['q']:.3f}, {own['iterations']} passes; "
        f"peer {peer['q']:.3f}, {peer['iterations']} sweeps, {peer['seconds']:.2f} s"
        if "q" in peer
        else f"error {mean_error(own) / mean_error(peer):.2f} of the peer's"
    )
    return [
        peer["case"],
        f"{peer['peer']}: {peer['method']}",
        own["method"],
        f"{own['threads']}, peer {peer['threads']}",
        f"{ratio.faster:.1f}",
        "" if ratio.faster_cpu is None else f"{ratio.faster_cpu:.1f}",
        "" if ratio.needed is None else f"{ratio.needed:.0f}",
        reached,
        ratio.verdict,
    ]


def aligned(head: list[str], rows: list[list[str]]) -> str:
    """Columns as wide as their widest cell."""
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]
    lines = [head, ["-" * width for width in widths], *rows]
    return "\n".join("  ".join(map(str.ljust, cells, widths)).rstrip() for cells in lines)
